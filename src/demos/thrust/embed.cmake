# Makes the levels part of the program (level_texts.h).
#
#   cmake -DLEVELS=1.txt,2.txt -DOUTPUT=level_texts.cpp -P embed.cmake

cmake_minimum_required(VERSION 3.16)

string(REPLACE "," ";" LEVELS "${LEVELS}")
set(texts "")
foreach(LEVEL ${LEVELS})
    file(READ "${LEVEL}" text)
    string(APPEND texts "    R\"level(${text})level\",\n")
endforeach()
file(WRITE "${OUTPUT}" "#include \"thrust/level_texts.h\"

namespace thrust {

const std::vector<std::string_view> levelTexts = {
${texts}};

}  // namespace thrust
")
