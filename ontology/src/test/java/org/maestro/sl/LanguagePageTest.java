package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Each example of the page about the language is of the kind that the page says. */
class LanguagePageTest {

  private static final Path PAGE = Path.of("..", "docs", "maestro-sl.md");
  private static final Pattern BLOCK = Pattern.compile("(?s)```(\\w+)\n(.*?)```");
  private static final Set<String> FLUENTS = Set.of("illuminance", "level", "power", "charge");
  private static final Map<String, Consumer<String>> PARSERS =
      Map.of(
          "formula",
          text -> SlParser.formula(text, FLUENTS::contains),
          "body",
          text -> SlParser.body(text, FLUENTS::contains),
          "effect",
          text -> SlParser.effect(text, FLUENTS::contains),
          "expression",
          SlParser::expression,
          "fact",
          SlParser::fact,
          "content",
          SlParser::content);

  private record Example(String kind, String text) {}

  private static List<Example> examples() throws IOException {
    List<Example> examples = new ArrayList<>();
    Matcher block = BLOCK.matcher(Files.readString(PAGE));
    while (block.find()) {
      String kind = block.group(1);
      block.group(2).lines().forEach(line -> examples.add(new Example(kind, line)));
    }
    return examples;
  }

  @Test
  void eachExampleIsReadAsItsKind() throws IOException {
    Set<String> kinds = new TreeSet<>();
    for (Example example : examples()) {
      kinds.add(example.kind());
      assertThat(PARSERS).containsKey(example.kind());
      assertThatCode(() -> PARSERS.get(example.kind()).accept(example.text()))
          .as(example.toString())
          .doesNotThrowAnyException();
    }
    assertThat(kinds).isEqualTo(new TreeSet<>(PARSERS.keySet()));
  }

  @Test
  void eachWordOfTheLanguageHasAnExample() throws IOException {
    String all = examples().stream().map(Example::text).reduce("", (one, next) -> one + next);
    assertThat(
            List.of(
                "and",
                "or",
                "not",
                "imply",
                "exists",
                "forall",
                "unknown",
                "keep",
                "at",
                "after",
                "until",
                "whenever",
                "once",
                "when",
                "assign",
                "increase",
                "decrease",
                "sense",
                "max",
                "=",
                "<",
                "<=",
                ">=",
                "+",
                "*",
                "/",
                "-",
                "seq",
                "par",
                "if",
                "while",
                "foreach",
                "let",
                "value",
                "one",
                "run",
                "try",
                "recover",
                "finally",
                "achieve",
                "do",
                "assert",
                "wait",
                "return",
                "fail"))
        .allSatisfy(word -> assertThat(all).contains("(" + word + " "));
  }
}
