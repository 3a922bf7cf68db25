# Makes the viewer part of the program: puts the style and the scripts that viewer.html names into it and writes it as
# C++, in two pieces, cut where the recording belongs (viewer_page.h).
#
#   cmake -DPAGE=viewer.html -DOUTPUT=viewer_page.cpp -P embed.cmake

cmake_minimum_required(VERSION 3.16)

get_filename_component(folder "${PAGE}" DIRECTORY)
file(READ "${PAGE}" page)

# The sample is there to work on the raw page.
string(REPLACE "<script src=\"viewer/sample.js\"></script>\n" "" page "${page}")

# Replaces each tag that names a file, found by the pattern, by an element that holds the file.
function(embed_files pattern element)
    string(REGEX MATCHALL "${pattern}" tags "${page}")
    foreach(tag IN LISTS tags)
        string(REGEX REPLACE "${pattern}" "\\1" name "${tag}")
        file(READ "${folder}/${name}" content)
        if(content MATCHES "</${element}")
            message(FATAL_ERROR "${name} must not contain </${element}: it would end there")
        endif()
        string(REPLACE "${tag}" "<${element}>\n${content}</${element}>" page "${page}")
    endforeach()
    set(page "${page}" PARENT_SCOPE)
endfunction()

embed_files("<link rel=\"stylesheet\" href=\"([^\"]+)\">" style)
embed_files("<script src=\"([^\"]+)\"></script>" script)

set(opening "<script id=\"recording\" type=\"application/json\">")
string(FIND "${page}" "${opening}</script>" cut)
if(cut EQUAL -1)
    message(FATAL_ERROR "${PAGE} has no place for a recording: ${opening}</script>")
endif()
string(LENGTH "${opening}" length)
math(EXPR cut "${cut} + ${length}")
string(SUBSTRING "${page}" 0 ${cut} head)
string(SUBSTRING "${page}" ${cut} -1 tail)

# A piece as a list of characters: a string literal may not be that long everywhere.
function(as_characters piece result)
    file(WRITE "${OUTPUT}.piece" "${piece}")
    file(READ "${OUTPUT}.piece" bytes HEX)
    file(REMOVE "${OUTPUT}.piece")
    string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
    set(${result} "${bytes}" PARENT_SCOPE)
endfunction()

as_characters("${head}" head)
as_characters("${tail}" tail)
file(WRITE "${OUTPUT}" "#include <string_view>

namespace demo {

static const char head[] = {
${head}};
static const char tail[] = {
${tail}};

extern const std::string_view viewerPageHead, viewerPageTail;
const std::string_view viewerPageHead(head, sizeof head);
const std::string_view viewerPageTail(tail, sizeof tail);

}  // namespace demo
")
