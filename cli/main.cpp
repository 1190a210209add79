// The program `hottel`.
#include "cli/command.h"

int main(int argc, char** argv) {
  hottel::Commands commands;
  hottel::add_solve(commands);
  hottel::add_plan(commands);
  hottel::add_factors(commands);
  hottel::add_visibility(commands);
  hottel::add_check(commands);
  hottel::add_compare(commands);
  hottel::add_reference(commands);
  hottel::add_generate(commands);
  hottel::add_convert(commands);
  hottel::add_view(commands);
  hottel::add_animate(commands);
  hottel::add_store(commands);
  return commands.run(argc, argv);
}
