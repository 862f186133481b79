package org.maestro.agents.content;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.Argument;
import org.maestro.sl.Content;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

class WordsTest {

  @Test
  void whatWasWrittenIsReadBack() {
    Map<String, Argument> parameters = new TreeMap<>();
    parameters.put(
        "object",
        new Argument(
            new Term.Name("Cup"),
            Optional.of("https://w3id.org/maestro/home/bob#Cup"),
            Map.of("position", List.of(new Term.Text("4.5 1.5 0.05")))));
    parameters.put("level", new Argument(new Term.Number(0.5), Optional.empty(), Map.of()));

    String text =
        Words.print(
            Words.content(
                "perform",
                Words.named("feature", Words.name("pick")),
                Orders.parameters("parameters", parameters)));
    Words words = Words.of(Words.parse(text).get(0));

    assertThat(words.string("feature")).contains("pick");
    assertThat(Orders.arguments(words.find("parameters").orElseThrow())).isEqualTo(parameters);
  }

  @Test
  void thePapersMessageCarriesItsGoal() {
    Content content = Words.parse("\"\"(initCNP (:goal (canSee ?agent GreenObject)))\"\"").get(0);

    assertThat(content.operator()).isEqualTo("initCNP");
    assertThat(Words.of(content).find("goal").flatMap(Words::formula))
        .contains(SlParser.formula("(canSee ?agent GreenObject)"));
  }

  @Test
  void outputsTravelAsTerms() {
    Map<String, Term> outputs =
        Map.of("found", new Term.Truth(true), "pose", new Term.Text("1 2 0"));

    String text = Words.print(Words.content("inform", Words.terms("outputs", outputs)));

    assertThat(Words.of(Words.parse(text).get(0)).termsOf("outputs")).isEqualTo(outputs);
  }

  /** A stranger's name is one word, or a text, whatever stands in it. */
  @Test
  void aNameIsReadAsItWasGiven() {
    for (String name :
        List.of(
            "hostile-1",
            "cli@http://a:7/acc",
            "G1) (:goal \"x",
            "",
            "\u001b\n",
            "007",
            "1e999",
            "½",
            "true")) {
      String text = Words.print(Words.content("inform", Words.named("member", Words.name(name))));

      assertThat(Words.parse(text)).hasSize(1);
      Words words = Words.of(Words.parse(text).get(0));
      assertThat(words.all()).hasSize(1);
      assertThat(words.string("member")).contains(name);
    }
  }
}
