#include "sim/campaign/wiring/colour_words.h"

#include <algorithm>
#include <initializer_list>

namespace robosim::wiring {
namespace {

bool begins(const std::string& word, std::initializer_list<const char*> beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const char* one) { return word.starts_with(one); });
}

bool is_in(const std::string& word, std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* one) { return word == one; });
}

// Returns whether the word negates a neighbouring word for the line, as "no" does.
bool negates(const std::string& word) {
  return is_in(word,
               {"no",      "not",    "off",     "out",     "without", "sin",    "fuera",   "nao",    "sem",
                "fora",    "hors",   "pas",     "sans",    "kein",    "nicht",  "senza",   "fuori",  "non",
                "yok",     "tidak",  "disi",    "outside", "aucun",   "aucune", "ninguna", "ningun", "nenhum",
                "nenhuma", "nessun", "nessuna", "keine",   "neither", "nor",    "none"}) ||
         begins(word, {"lost", "perd", "lose", "losing", "kayb", "verlor"});
}

bool has_pair(const WordList& words, bool (*colour)(const std::string&)) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if ((colour(words[i]) && is_line(words[i + 1])) || (is_line(words[i]) && colour(words[i + 1])))
      return true;
  return false;
}

}  // namespace

bool is_black(const std::string& word) {
  return begins(word, {"black", "negr", "preto", "preta", "noir", "schwarz", "siyah", "hitam", "zwart",
                       "escur", "oscur"}) ||
         is_in(word, {"nero", "nera", "neri", "dark", "blk"});
}

bool is_white(const std::string& word) {
  return begins(word, {"white", "blanc", "branc", "bianc", "weiss", "beyaz", "putih"}) || word == "wht";
}

bool is_line(const std::string& word) {
  return is_in(word, {"line", "lines", "linea", "lineas", "linha", "linhas", "ligne", "linie", "cizgi",
                      "cizgiyi", "garis", "faixa", "fita", "online", "lijn", "linia"}) ||
         begins(word, {"cizgi", "surligne"});
}

int colour_of(const WordList& words) {
  const bool black = std::any_of(words.begin(), words.end(), is_black);
  const bool white = std::any_of(words.begin(), words.end(), is_white);
  return black == white ? 0 : black ? 1 : -1;
}

int line_of(const WordList& words) {
  if (!std::any_of(words.begin(), words.end(), is_line)) return 0;
  return std::any_of(words.begin(), words.end(), negates) ? -1 : 1;
}

int line_in_sentence(const WordList& words) {
  const int line = line_of(words);
  const bool is_seen = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return begins(word,
                  {"detect", "see", "saw", "found", "touch", "gor", "erkannt", "sieht", "voit", "surl"}) ||
           is_in(word, {"on", "over", "sobre", "na", "en", "sur", "auf", "su", "sulla", "ve", "encima", "em",
                        "pada", "uzerinde"});
  });
  // "Continue until both sensors see the line" describes the opposite of the branch's condition.
  if (std::any_of(words.begin(), words.end(), [](const std::string& word) {
        return is_in(word, {"until", "hasta", "ate", "bis", "jusqu", "fino", "kadar", "sampai"});
      }))
    return 0;
  const bool follows = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return begins(word, {"follow", "segui", "suiv", "takip", "pengikut"});
  });
  return line < 0 || (is_seen && !follows) ? line : 0;
}

bool has_white_line(const WordList& words) { return has_pair(words, is_white); }
bool has_black_line(const WordList& words) { return has_pair(words, is_black); }

bool is_instruction(const WordList& words) {
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return is_in(word, {"use",   "change", "set",    "put",    "make",  "swap",    "select",  "choose",
                        "flip",  "usa",    "usar",   "use",    "poner", "pon",     "ponga",   "troque",
                        "mude",  "trocar", "mudar",  "mettez", "metti", "mettere", "usare",   "ersetzen",
                        "setze", "setzen", "kullan", "yap",    "ganti", "ubah",    "gunakan", "mettre"}) ||
           begins(word, {"replac", "invert", "cambi", "chang", "utili", "verwend", "anpass", "degisti"});
  });
}

bool is_condition(const WordList& words) {
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return is_in(word, {"if", "si", "se", "wenn", "falls", "eger", "jika", "kalau", "unless", "your"});
  });
}

int level_of_word(const std::string& word) {
  if (is_in(word, {"high", "1", "alto", "haut", "hoch", "yuksek", "tinggi", "gt"})) return 1;
  if (is_in(word, {"low", "0", "bajo", "baixo", "bas", "basso", "niedrig", "dusuk", "rendah", "lt"}))
    return -1;
  return 0;
}

}  // namespace robosim::wiring
