// The program `hottel`.
#include "cli/command.h"

int main(int argc, char** argv) {
  hottel::Commands commands;
  hottel::add_all_commands(commands);
  return commands.run(argc, argv);
}
