package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SlParserTest {

  private static final Content PAPERS_GOAL =
      new Content(
          "initCNP",
          List.of(
              new Content.Argument.Named(
                  "goal",
                  List.of(
                      new Content.Argument.OfFormula(
                          new Formula.Atom(
                              "canSee",
                              List.of(
                                  new Term.Variable("agent"), new Term.Name("GreenObject"))))))));

  @Test
  void readsThePapersContentWithAnyQuotes() {
    String bare = "(initCNP (:goal (canSee ?agent GreenObject)))";
    for (String text :
        List.of(
            bare,
            "\"" + bare + "\"",
            "\"\"" + bare + "\"\"",
            "\u201d\u201d" + bare + "\u201d\u201d",
            "(initCNP :goal (canSee ?agent GreenObject))")) {
      assertThat(SlParser.content(text)).containsExactly(PAPERS_GOAL);
    }
    assertThat(SlPrinter.print(PAPERS_GOAL)).isEqualTo(bare);
  }

  @Test
  void readsSeveralContentElements() {
    assertThat(SlParser.content("(cancel G1) (explain G2 :depth 2)"))
        .extracting(Content::operator)
        .containsExactly("cancel", "explain");
  }

  @Test
  void writesContentElementsAndTheirArguments() {
    String text = "(cancel G1) (explain G2 (:depth 2 (assign (level l) 1)) (inform (in Cup a)))";
    List<Content> contents = SlParser.content(text);
    assertThat(SlPrinter.print(contents)).isEqualTo(text);
    assertThat(contents.get(1).arguments())
        .extracting(SlPrinter::print)
        .containsExactly("G2", "(:depth 2 (assign (level l) 1))", "(inform (in Cup a))");
  }

  @Test
  void readsArgumentsByTheirLooks() {
    Content content =
        SlParser.content(
                "(inform (in Cup zone-b) (and (a ?x) (assign (f) 1)) (and (a ?x)) (price 2 (:of x)))")
            .get(0);
    assertThat(content.arguments())
        .extracting(argument -> (Object) argument.getClass())
        .containsExactly(
            Content.Argument.OfFormula.class,
            Content.Argument.OfEffect.class,
            Content.Argument.OfFormula.class,
            Content.Argument.Nested.class);
  }

  @Test
  void readsUnknownAndSenseByTheFluentsNames() {
    assertThat(SlParser.formula("(unknown (lux a))", "lux"::equals))
        .isEqualTo(
            new Formula.UnknownNumber(new Expression.Fluent("lux", List.of(new Term.Name("a")))));
    assertThat(SlParser.formula("(unknown (lux a))")).isInstanceOf(Formula.UnknownAtom.class);
    assertThat(SlParser.effect("(sense (lux a) (in b c))", "lux"::equals))
        .isEqualTo(
            new Effect.All(
                List.of(
                    SlParser.effect("(sense (lux a))", "lux"::equals),
                    SlParser.effect("(sense (in b c))"))));
  }

  @Test
  void readsFacts() {
    assertThat(SlParser.fact("(= (level ?self) ?level)")).isInstanceOf(Fact.Equation.class);
    assertThat(SlParser.fact("(not (open door-1))")).isInstanceOf(Fact.Excluded.class);
    assertThat(SlParser.fact("(unknown (in Cup rose))")).isInstanceOf(Fact.Unknown.class);
    assertThat(((Fact.Holds) SlParser.fact("(illuminance zone-b)")).asFluent())
        .isEqualTo(SlParser.expression("(illuminance zone-b)"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "(and (in Cup zone-b) | 21 | the end of the text",
        "(in Cup zone-b)) | 16 | \")\"",
        "(in Cup (zone b)) | 9 | \"(zone ...)\"",
        "(not) | 5 | \")\"",
        "(not (a) (b)) | 10 | \"(b ...)\"",
        "(>= (illuminance z) bright) | 21 | \"bright\"",
        "(< 1) | 5 | \")\"",
        "(= 1 2 3) | 8 | \"3\"",
        "(exists ?x (in ?x z)) | 9 | \"?x\"",
        "(exists (?x -) (in ?x z)) | 14 | \")\"",
        "(exists (x - Thing) (in ?x z)) | 10 | \"x\"",
        "(and (keep (a))) | 6 | \"(keep ...)\"",
        "(in Cup :zone) | 9 | \":zone\"",
        "(in Cup \"zone) | 15 | the end of the text",
        "(in Cup zo!ne) | 9 | \"zo!ne\"",
        "(in <http://a b> c) | 14 | \" \"",
        "() | 1 | \"()\"",
        "Cup | 1 | \"Cup\"",
        "(unknown (and (a))) | 10 | \"(and ...)\"",
        "(unknown) | 9 | \")\"",
        "(> 1e999 2) | 4 | \"1e999\"",
        "((a) b) | 2 | \"(a ...)\"",
      })
  void namesColumnAndFindingOfAFault(String text, int column, String found) {
    SlSyntaxException fault =
        catchThrowableOfType(SlSyntaxException.class, () -> SlParser.formula(text));
    assertThat(fault.column()).as(fault.getMessage()).isEqualTo(column);
    assertThat(fault.found()).isEqualTo(found);
    assertThat(fault).hasMessageMatching("At column \\d+ .* was expected, but found .*\\.");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "(assign level 1) | 9",
        "(assign (level l) on) | 19",
        "(when (a)) | 10",
        "(sense) | 7",
        "(or (a) (b)) | 1",
        "(not (not (a))) | 6",
      })
  void namesTheColumnOfAFaultyEffect(String text, int column) {
    SlSyntaxException fault =
        catchThrowableOfType(SlSyntaxException.class, () -> SlParser.effect(text));
    assertThat(fault.column()).as(fault.getMessage()).isEqualTo(column);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "initCNP | 1",
        "`` | 1",
        "\"\"(initCNP (:goal (canSee ?agent))\"\" | 36",
        "(initCNP :goal) | 10",
        "(initCNP (:goal (and (assign (f) x)))) | 34",
        "(inform (and (in a b) (or (c) d))) | 31",
      })
  void namesTheColumnOfFaultyContent(String text, int column) {
    SlSyntaxException fault =
        catchThrowableOfType(SlSyntaxException.class, () -> SlParser.content(text));
    assertThat(fault.column()).as(fault.getMessage()).isEqualTo(column);
  }

  @Test
  void refusesDeepNestingWithOneClearError() {
    String deep = "(not ".repeat(100_000) + "(a)" + ")".repeat(100_000);
    SlSyntaxException fault =
        catchThrowableOfType(SlSyntaxException.class, () -> SlParser.formula(deep));
    assertThat(fault).hasMessageContaining("nesting of at most 100");
    assertThat(fault.column()).isEqualTo(501);
  }
}
