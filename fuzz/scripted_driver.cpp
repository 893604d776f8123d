// A driver that says what a file holds, whatever it is asked: one line for each line that it reads.
// It ends behind the last one. Without sanitizers, so that it starts within a millisecond.
#include <fstream>
#include <iostream>
#include <string>

int main(int argc, char** argv) {
  std::ifstream script(argc > 1 ? argv[1] : "", std::ios::binary);
  std::string asked;
  std::string answer;
  while (script.peek() != std::ifstream::traits_type::eof() && std::getline(std::cin, asked)) {
    std::getline(script, answer);
    std::cout << answer << '\n' << std::flush;
  }
  return 0;
}
