package org.maestro.language;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * The Java code knows no language: each word in its texts is of the format of grammars, of
 * MAESTRO-SL or of the vocabulary, or of a message to who writes grammars.
 */
class WordsOfNoLanguageTest {
  private static final Path SOURCES = Path.of("src/main/java/org/maestro/language");
  private static final List<String> GRAMMARS = List.of("en.grammar", "de.grammar");
  private static final Pattern TEXT = Pattern.compile("\"((?:[^\"\\\\]|\\\\.)*)\"");
  private static final Pattern WORD = Pattern.compile("(?<![\\\\\\p{L}])\\p{L}[\\p{L}-]+");
  private static final Pattern TEMPLATE = Pattern.compile("->\\s+(.*?)(\\s+!\\d+)?$");
  private static final Pattern COMMENT = Pattern.compile("(?m)^\\s*(\\*|/\\*|//).*$");

  /** Where faults of grammars are told to who writes them, in sentences. */
  private static final Pattern FAULT =
      Pattern.compile("(?s)(fault(\\.apply)?|\\w+Exception|Doubt\\.Nothing)\\(.*?\\);\\n");

  /** Words of MAESTRO-SL, which messages are made of. */
  private static final Set<String> MESSAGES =
      Set.of(
          "initCNP",
          "goal",
          "perform",
          "script",
          "cancel",
          "question",
          "last",
          "whenever",
          "once",
          "inform",
          "facts",
          "query-if",
          "query-ref",
          "explain",
          "seq",
          "until",
          "at",
          "after",
          "every",
          "count",
          "value",
          "history",
          "observed",
          "self",
          "speaker",
          "here",
          "it",
          "where",
          "undo");

  /** Words of the shipped vocabulary. */
  private static final Set<String> VOCABULARY =
      Set.of(
          "Thing",
          "Device",
          "Zone",
          "Room",
          "Person",
          "Relation",
          "inside",
          "pose",
          "position",
          "boolean",
          "decimal",
          "double",
          "integer",
          "duration",
          "string",
          "DEG",
          "SEC",
          "PERCENT",
          "Listener");

  /** Words of the format of grammars, and kinds of meanings. */
  private static final Set<String> FORMAT =
      Set.of(
          "language",
          "pattern",
          "ending",
          "irregular",
          "number",
          "times",
          "spelling",
          "phrase",
          "list",
          "comma",
          "Utterance",
          "WantTail",
          "VERB",
          "PARTICLE",
          "SUBJECT",
          "OBJECT",
          "OTHERS",
          "superlative",
          "REST",
          "FRAME",
          "WHOLE",
          "BEFORE",
          "SAYING",
          "frame",
          "role",
          "word",
          "noun",
          "name",
          "adj",
          "prep",
          "fluent",
          "more",
          "less",
          "howMuch",
          "state",
          "text",
          "command",
          "rule",
          "statement",
          "answer",
          "social",
          "nowhere",
          "grammar",
          "en",
          // Lists and categories that not each language needs.
          "verb-place",
          "joining",
          "turning",
          "singular",
          "owning",
          "plural",
          "ing",
          "vowel",
          "noun-forms",
          "plural-forms",
          "adjective-forms",
          "name-forms",
          "StateForm",
          "NameOwning",
          "beside",
          "positive",
          "subordinating",
          "unfinished",
          "High",
          "Low",
          "Opening",
          "half",
          "tohalf",
          "timepm",
          // What a grammar has from another one.
          "like",
          "phrases",
          // Rules of reports, and what stands in their places.
          "report",
          "reports",
          "Report",
          "report-foreign",
          "ability",
          "class",
          "feature",
          "formula",
          "relation",
          "step",
          "things",
          "told",
          "named",
          // The end of a phrase's name.
          "many",
          // Patterns of letters.
          "A-Z",
          "E-",
          "A-Za-z",
          "a-z",
          "Cf",
          "Cntrl");

  @Test
  void noTextOfTheCodeIsOfALanguage() throws IOException {
    Set<String> known = structural();
    Map<String, Set<String>> unknown = new TreeMap<>();
    for (Path file : sources()) {
      String code = COMMENT.matcher(Files.readString(file)).replaceAll("");
      Set<String> words =
          TEXT.matcher(FAULT.matcher(code).replaceAll(";"))
              .results()
              .flatMap(text -> WORD.matcher(text.group(1)).results())
              .map(MatchResult::group)
              .filter(word -> !known.contains(word))
              .collect(Collectors.toCollection(TreeSet::new));
      if (!words.isEmpty()) {
        unknown.put(String.valueOf(file.getFileName()), words);
      }
    }

    assertThat(unknown).isEmpty();
  }

  private static List<Path> sources() throws IOException {
    try (Stream<Path> files = Files.walk(SOURCES)) {
      List<Path> sources =
          files
              .filter(file -> file.toString().endsWith(".java"))
              .sorted(Comparator.naturalOrder())
              .toList();
      assertThat(sources).hasSizeGreaterThan(30);
      return sources;
    }
  }

  /** What means the same in each grammar is of no language. */
  private static Set<String> structural() {
    Set<String> words = new TreeSet<>(wordsOf(GRAMMARS.get(0)));
    GRAMMARS.forEach(file -> words.retainAll(wordsOf(file)));
    assertThat(words).contains("become", "ask", "answer-yes").doesNotContain("turn", "mach");
    words.addAll(MESSAGES);
    words.addAll(VOCABULARY);
    words.addAll(FORMAT);
    return words;
  }

  /** Heads and labels of what is meant, categories, and names of lists and phrases. */
  private static Set<String> wordsOf(String grammar) {
    Set<String> words = new TreeSet<>();
    for (String line : text(grammar).split("\n")) {
      TEMPLATE
          .matcher(line)
          .results()
          .flatMap(template -> Arrays.stream(template.group(1).split("[()\\s]+")))
          .forEach(words::add);
      String[] sides = line.split("\\s+=\\s+", 2);
      String[] left = sides[0].split("\\s+");
      words.add(left[left.length - 1]);
      if (sides.length > 1 && Character.isUpperCase(line.charAt(0))) {
        Arrays.stream(sides[1].split("[\\s/?]+"))
            .map(item -> item.replaceFirst("^\\w+:", ""))
            .filter(item -> !item.isEmpty() && Character.isUpperCase(item.charAt(0)))
            .forEach(words::add);
      }
      if (line.startsWith("phrase ")) {
        Pattern.compile("\\{(\\w+)")
            .matcher(line)
            .results()
            .map(m -> m.group(1))
            .forEach(words::add);
      }
    }
    return words;
  }

  private static String text(String resource) {
    try (InputStream stream = Language.class.getResourceAsStream(resource)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
