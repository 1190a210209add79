// What an XML text leaves to a document type definition, which is not read.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace hottel {

// Why the text of a file does not say all that it means, and where: the offset of a byte.
struct XmlProblem {
  std::size_t offset = 0;
  std::string text;  // the end of a sentence whose subject is the file
};

// Returns the first place whose meaning is not in the text itself.
//
//   (1) a reference other than &amp; &lt; &gt; &quot; &apos; and &#N; &#xN;, or an & that begins none: its text would
//       stand in names as it is typed
//   (2) in the document type declaration: attribute lists, whose defaults would be missing, and parameter entities
//   (3) entities that are declared and not used are harmless; comments, CDATA and processing instructions have no
//       references
//
// COST: linear.
std::optional<XmlProblem> unresolved_reference(std::string_view xml);

}  // namespace hottel
