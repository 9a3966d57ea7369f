// An OBJ file with other texture coordinates: everything else stays as it is, byte for byte.
#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <glog/logging.h>

#include "cirque/core/parallel.h"
#include "cirque/io/file_input.h"
#include "cirque/io/mesh_formats.h"
#include "cirque/io/text_writer.h"

namespace cirque {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr char kTelling[] = {'\\', '#', '\r'};
constexpr std::size_t kBlockBytes = std::size_t{1} << 18;

std::string_view Between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// Whether lines end at '\n' and words at blanks, and nowhere else: as most stretches are.
bool IsPlain(std::string_view text) {
  return std::none_of(std::begin(kTelling), std::end(kTelling),
                      [&](char c) { return std::memchr(text.data(), c, text.size()) != nullptr; });
}

enum class Kind {
  kFace,       ///< f
  kReference,  ///< other lines that may name texture coordinates: l, surf
  kTexture,    ///< vt
  kOther,
};

Kind KindOf(std::string_view keyword) {
  if (keyword == "f") return Kind::kFace;
  if (keyword == "vt") return Kind::kTexture;
  return keyword == "l" || keyword == "surf" ? Kind::kReference : Kind::kOther;
}

/// A line of the file from its first blank or word, continued lines as one.
struct Line {
  std::string_view text;  ///< with its newline
  Kind kind = Kind::kOther;
  std::vector<std::string_view> words;  ///< behind the first one, where they are references
};

bool HasReferences(Kind kind) { return kind == Kind::kFace || kind == Kind::kReference; }

/// What a stretch of the file holds.
struct Stretch {
  std::string_view text;
  bool is_plain = false;
  Index corners = 0;                   ///< of faces
  const char* first_of_map = nullptr;  ///< where its first line of texture or of a face begins
};

/// Stretches of whole lines that can be told without reading from the start: behind newlines with no
/// backslash before them.
std::vector<Stretch> CutIntoStretches(std::string_view text) {
  std::vector<Stretch> stretches;
  while (!text.empty()) {
    std::size_t end = std::min(kBlockBytes, text.size());
    while (end < text.size()) {
      end = text.find('\n', end);
      if (end == std::string_view::npos) break;
      const std::string_view before = text.substr(0, end++);
      if (!before.ends_with('\\') && !before.ends_with("\\\r")) break;
    }
    stretches.push_back({text.substr(0, end)});
    text.remove_prefix(stretches.back().text.size());
  }
  return stretches;
}

const char* EndOfPlainLine(std::string_view text) {
  const auto* newline = static_cast<const char*>(std::memchr(text.data(), '\n', text.size()));
  return newline ? newline + 1 : text.data() + text.size();
}

/// Calls visit(line) for the lines of plain text that hold a word.
template <class Visit>
void ForEachPlainLine(std::string_view text, const Visit& visit) {
  Line line;
  for (const char *c = text.data(), *const stop = c + text.size(); c != stop;) {
    line.text = Between(c, EndOfPlainLine(Between(c, stop)));
    c += line.text.size();
    const char* const end = c - (line.text.ends_with('\n') ? 1 : 0);
    const char* at = line.text.data();
    const auto next_word = [&at, end] {
      while (at != end && IsBlank(*at)) ++at;
      const char* const first = at;
      while (at != end && !IsBlank(*at)) ++at;
      return Between(first, at);
    };
    line.kind = KindOf(next_word());
    line.words.clear();
    if (HasReferences(line.kind)) {
      for (auto word = next_word(); !word.empty(); word = next_word()) line.words.push_back(word);
    }
    visit(line);
  }
}

/// The same for any text, as the reader of the file sees it.
template <class Visit>
void ForEachScannedLine(std::string_view text, const Visit& visit) {
  Line line;
  TextScanner scanner("", text, TextScanner::Continuation::kBackslash, TextScanner::Mark::kIsText);
  while (scanner.NextLine()) {
    const std::string_view keyword = scanner.Word();
    const char* first = keyword.data();
    while (first != text.data() && IsBlank(first[-1])) --first;
    line.kind = KindOf(keyword);
    line.words.clear();
    if (HasReferences(line.kind)) {
      while (!scanner.AtLineEnd()) line.words.push_back(scanner.Word());
    }
    line.text = Between(first, scanner.BytesAfterLine().data());
    visit(line);
  }
}

template <class Visit>
void ForEachLine(std::string_view text, bool is_plain, const Visit& visit) {
  return is_plain ? ForEachPlainLine(text, visit) : ForEachScannedLine(text, visit);
}

/// The reader passes over faces of fewer corners.
bool IsReadFace(const Line& line) { return line.kind == Kind::kFace && line.words.size() >= 3; }

void Count(Stretch* stretch) {
  stretch->is_plain = IsPlain(stretch->text);
  ForEachLine(stretch->text, stretch->is_plain, [&](const Line& line) {
    if (line.kind != Kind::kFace && line.kind != Kind::kTexture) return;
    if (!stretch->first_of_map) stretch->first_of_map = line.text.data();
    if (IsReadFace(line)) stretch->corners += static_cast<Index>(line.words.size());
  });
}

/// Whether a word of a line that the reader passes over begins with a vertex: of another word a part
/// could become one with what follows it ("1.//" in front of "#INF", "\\/1" at a line's end).
bool IsReference(std::string_view word) {
  const std::string_view vertex = word.substr(0, word.find('/'));
  return !vertex.empty() && vertex.find_first_not_of("+-0123456789") == std::string_view::npos;
}

/// The file's own newline: a lone CR where there is no other, as behind it an LF would join it.
std::string_view NewlineOf(std::string_view text) {
  const std::size_t at = text.find('\n');
  if (at == std::string_view::npos) return text.find('\r') == at ? "\n" : "\r";
  return at > 0 && text[at - 1] == '\r' ? "\r\n" : "\n";
}

/// Whether without the line the CR before it and the LF behind it would be one newline.
bool WouldJoin(std::string_view text, std::string_view line) {
  const char* const end = line.data() + line.size();
  return line.data() != text.data() && line.data()[-1] == '\r' &&
         end != text.data() + text.size() && *end == '\n';
}

/// Writes lines with the texture coordinates of the corners, from `corner` on.
class LineWriter {
 public:
  LineWriter(const PolygonSoup& textured, Index corner, TextWriter* out)
      : textured_(textured), corner_(corner), out_(*out) {}

  void Write(const Stretch& stretch) {
    const std::string_view text = stretch.text;
    const char* copied = text.data();  // all before is written
    ForEachLine(text, stretch.is_plain, [&](const Line& line) {
      if (line.kind == Kind::kOther) return;
      out_.Text(Between(copied, line.text.data()));
      copied = line.text.data() + line.text.size();
      if (line.kind != Kind::kTexture) {
        WriteReferences(line);
      } else if (WouldJoin(text, line.text)) {
        out_.Text("\n");
      }
    });
    out_.Text(Between(copied, text.data() + text.size()));
  }

 private:
  void WriteReferences(const Line& line) {
    const bool is_face = IsReadFace(line);
    const char* copied = line.text.data();
    for (const std::string_view word : line.words) {
      out_.Text(Between(copied, word.data()));
      copied = word.data() + word.size();
      if (!is_face && !IsReference(word)) {
        out_.Text(word);
      } else {
        WriteReference(word, is_face ? textured_.corner_texture[corner_++] : kNone);
      }
    }
    out_.Text(Between(copied, line.text.data() + line.text.size()));
  }

  /// v, v/vt, v//vn or v/vt/vn with another vt.
  void WriteReference(std::string_view word, Index texture) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const std::size_t second = std::min(word.find('/', slash + 1), word.size());
    const std::string_view normal = word.substr(second);  // with its slash
    out_.Text(word.substr(0, slash));
    if (texture != kNone) {
      out_.Text("/");
      out_.Number(texture + 1);
    } else if (normal.size() > 1) {
      out_.Text("/");
    }
    if (normal.size() > 1) out_.Text(normal);
  }

  const PolygonSoup& textured_;
  Index corner_;
  TextWriter& out_;
};

/// The pieces of the stretches, each from the corner that the ones before it end with.
TextPieces WriteStretches(const std::vector<Stretch>& stretches, const PolygonSoup& textured) {
  std::vector<Index> first_corner = {0};
  for (const Stretch& stretch : stretches) {
    first_corner.push_back(first_corner.back() + stretch.corners);
  }
  CHECK_EQ(static_cast<std::size_t>(first_corner.back()), textured.corner_texture.size());
  TextPieces pieces(stretches.size());
  const auto write = [&](int i) {
    TextWriter out;
    LineWriter(textured, first_corner[i], &out).Write(stretches[i]);
    pieces[i] = std::move(out).Take();
  };
  const auto count = static_cast<int>(stretches.size());
  if (first_corner.back() > kParallelBlock) {
    ParallelTasks(count, write);
  } else {
    for (int i = 0; i < count; ++i) write(i);  // threads would take longer to begin
  }
  return pieces;
}

TextPieces TextureLines(const PolygonSoup& textured, std::string_view newline) {
  TextWriter out;
  out.Lines(static_cast<int>(textured.texture.size()), [&](int i, TextWriter* line) {
    line->Text("vt ");
    line->Number(textured.texture[i].x());
    line->Text(" ");
    line->Number(textured.texture[i].y());
    line->Text(newline);
  });
  return std::move(out).TakePieces();
}

/// The stretch that holds the first line of the map, cut in two in front of it; the number of the
/// second part, or of stretches where no line is of the map.
std::size_t CutBeforeMap(std::vector<Stretch>* stretches) {
  const auto found = std::find_if(stretches->begin(), stretches->end(),
                                  [](const Stretch& s) { return s.first_of_map != nullptr; });
  if (found == stretches->end()) return stretches->size();
  const auto length = static_cast<std::size_t>(found->first_of_map - found->text.data());
  const Stretch before = {found->text.substr(0, length), found->is_plain};
  found->text.remove_prefix(length);
  const auto second = static_cast<std::size_t>(found - stretches->begin()) + 1;
  stretches->insert(found, before);
  return second;
}

}  // namespace

TextPieces RewriteObj(std::string_view text, const PolygonSoup& textured) {
  const bool has_mark = text.starts_with(kByteOrderMark);
  if (has_mark) text.remove_prefix(kByteOrderMark.size());
  std::vector<Stretch> stretches = CutIntoStretches(text);
  ParallelTasks(static_cast<int>(stretches.size()), [&](int i) { Count(&stretches[i]); });
  const std::size_t map = CutBeforeMap(&stretches);
  TextPieces pieces = WriteStretches(stretches, textured);
  TextPieces lines = TextureLines(textured, NewlineOf(text));
  pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(map),
                std::make_move_iterator(lines.begin()), std::make_move_iterator(lines.end()));
  // Without lines of texture that stood there, a word that begins with a mark would begin the file.
  const auto first = std::find_if(pieces.begin(), pieces.end(),
                                  [](const std::string& piece) { return !piece.empty(); });
  const bool is_misread = first != pieces.end() && first->starts_with(kByteOrderMark);
  if (has_mark || is_misread) pieces.insert(pieces.begin(), std::string(kByteOrderMark));
  return pieces;
}

}  // namespace cirque
