package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Bodies of scripts: what each form is read as, and in which sentence others are refused. */
class BodySyntaxTest {
  private static final Term ZONE = new Term.Name("zone-a");
  private static final Term ROSE = new Term.Name("rose");
  private static final Formula DARK = new Formula.Atom("dark", List.of(ZONE));
  private static final Body RUN = new Body.Run("light", List.of(ZONE));
  private static final Body FAIL = new Body.Fail("no");
  private static final TypedVariable LAMP = new TypedVariable("l", Optional.of("Lamp"));

  static Stream<Arguments> forms() {
    return Stream.of(
        Arguments.of("(seq (run light zone-a) (fail \"no\"))", new Body.Seq(List.of(RUN, FAIL))),
        Arguments.of("(par (run light zone-a) (fail \"no\"))", new Body.Par(List.of(RUN, FAIL))),
        Arguments.of(
            "(if (dark zone-a) (run light zone-a))", new Body.If(DARK, RUN, Optional.empty())),
        Arguments.of(
            "(if (dark zone-a) (run light zone-a) (fail \"no\"))",
            new Body.If(DARK, RUN, Optional.of(FAIL))),
        Arguments.of(
            "(while (dark zone-a) (run light zone-a))",
            new Body.While(DARK, RUN, OptionalInt.empty())),
        Arguments.of(
            "(while (dark zone-a) (run light zone-a) :most 3)",
            new Body.While(DARK, RUN, OptionalInt.of(3))),
        Arguments.of(
            "(while (dark zone-a) (hold zone-a \"base\"))",
            new Body.While(DARK, new Body.Hold(ZONE, "base", List.of()), OptionalInt.empty())),
        Arguments.of(
            "(hold zone-a \"base\" (run light zone-a) (fail \"no\"))",
            new Body.Hold(ZONE, "base", List.of(RUN, FAIL))),
        Arguments.of(
            "(say zone-a \"It is\" 3 ?x)",
            new Body.Say(
                ZONE, List.of(new Term.Text("It is"), new Term.Number(3), new Term.Variable("x")))),
        Arguments.of(
            "(ask ?who \"Where is\" zone-a \"?\" ?room Zone (run light zone-a))",
            new Body.Ask(
                new Term.Variable("who"),
                List.of(new Term.Text("Where is"), ZONE, new Term.Text("?")),
                new TypedVariable("room", Optional.of("Zone")),
                List.of(RUN))),
        Arguments.of(
            "(ask zone-a \"Well?\" ?it)",
            new Body.Ask(
                ZONE,
                List.of(new Term.Text("Well?")),
                new TypedVariable("it", Optional.empty()),
                List.of())),
        Arguments.of(
            "(ask zone-a \"Well?\" ?it (choice \"good\" 3 zone-a) (run light zone-a))",
            new Body.Ask(
                ZONE,
                List.of(new Term.Text("Well?")),
                new TypedVariable("it", Optional.empty()),
                Optional.of(
                    new AnswerFormat.Choice(
                        List.of(new Term.Text("good"), new Term.Number(3), ZONE))),
                List.of(RUN))),
        Arguments.of(
            "(ask zone-a \"Well?\" ?it (slider -1 1 0.5))",
            new Body.Ask(
                ZONE,
                List.of(new Term.Text("Well?")),
                new TypedVariable("it", Optional.empty()),
                Optional.of(new AnswerFormat.Slider(-1, 1, 0.5, "", "")),
                List.of())),
        Arguments.of(
            "(seq (ask zone-a \"Well?\" ?it (slider 1 7 1 \"not at all\" \"very\")) (fail \"no\"))",
            new Body.Seq(
                List.of(
                    new Body.Ask(
                        ZONE,
                        List.of(new Term.Text("Well?")),
                        new TypedVariable("it", Optional.empty()),
                        Optional.of(new AnswerFormat.Slider(1, 7, 1, "not at all", "very")),
                        List.of(FAIL))))),
        Arguments.of(
            "(seq (run light zone-a) (ask zone-a ?text ?n) (run light zone-a) (fail \"no\"))",
            new Body.Seq(
                List.of(
                    RUN,
                    new Body.Ask(
                        ZONE,
                        List.of(new Term.Variable("text")),
                        new TypedVariable("n", Optional.empty()),
                        List.of(RUN, FAIL))))),
        Arguments.of(
            "(tell CCA (initCNP (:goal (dark zone-a))))",
            new Body.Tell(
                new Term.Name("CCA"),
                new Content(
                    "initCNP",
                    List.of(
                        new Content.Argument.Named(
                            "goal", List.of(new Content.Argument.OfFormula(DARK))))))),
        Arguments.of(
            "(foreach (?l - Lamp) (dark zone-a) (run light zone-a))",
            new Body.ForEach(LAMP, DARK, RUN)),
        Arguments.of(
            "(let ?n (value (level lamp-1)) (run light zone-a) (fail \"no\"))",
            new Body.Let(
                "n",
                new Body.Source.Value(
                    new Expression.Fluent("level", List.of(new Term.Name("lamp-1")))),
                List.of(RUN, FAIL))),
        Arguments.of(
            "(let ?x (one (?l - Lamp) (dark zone-a)) (run light zone-a))",
            new Body.Let("x", new Body.Source.One(LAMP, DARK), List.of(RUN))),
        Arguments.of(
            "(let ?x (run light zone-a) (fail \"no\"))",
            new Body.Let("x", new Body.Run("light", List.of(ZONE)), List.of(FAIL))),
        Arguments.of(
            "(try (run light zone-a) (recover \"late\" (fail \"no\")) (recover (run light zone-a))"
                + " (finally (fail \"no\")))",
            new Body.Try(
                RUN,
                List.of(
                    new Body.Recovery(Optional.of("late"), FAIL),
                    new Body.Recovery(Optional.empty(), RUN)),
                Optional.of(FAIL))),
        Arguments.of("(achieve (dark zone-a))", new Body.Achieve(DARK)),
        Arguments.of(
            "(do move rose :speed 0.5 :to zone-a)",
            new Body.Do("move", ROSE, Map.of("to", ZONE, "speed", new Term.Number(0.5)))),
        Arguments.of("(do pick ?who)", new Body.Do("pick", new Term.Variable("who"), Map.of())),
        Arguments.of("(run light)", new Body.Run("light", List.of())),
        Arguments.of(
            "(assert (dark zone-a))",
            new Body.Assert(new Effect.Add(new Formula.Atom("dark", List.of(ZONE))))),
        Arguments.of("(wait (dark zone-a))", new Body.Await(DARK)),
        Arguments.of("(wait 30)", new Body.Pause(new Expression.OfTerm(new Term.Number(30)))),
        Arguments.of("(wait ?n)", new Body.Pause(new Expression.OfTerm(new Term.Variable("n")))),
        Arguments.of(
            "(express glad 0.8)", new Body.Express(new Term.Name("glad"), new Term.Number(0.8))),
        Arguments.of("(look zone-a)", new Body.Look(ZONE)),
        Arguments.of("(return zone-a)", new Body.Return(ZONE)),
        Arguments.of("(fail \"no\")", FAIL));
  }

  @ParameterizedTest
  @MethodSource("forms")
  void readsEachFormAndWritesItTheSame(String text, Body body) {
    assertThat(SlParser.body(text, name -> false)).isEqualTo(body);
    assertThat(SlPrinter.print(body)).isEqualTo(text);
  }

  @Test
  void aStepKnowsItsParts() {
    Body attempt =
        new Body.Try(
            RUN,
            List.of(new Body.Recovery(Optional.empty(), FAIL)),
            Optional.of(new Body.Seq(List.of(RUN))));
    assertThat(attempt.parts()).containsExactly(RUN, FAIL, new Body.Seq(List.of(RUN)));
    assertThat(new Body.If(DARK, RUN, Optional.of(FAIL)).parts()).containsExactly(RUN, FAIL);
    assertThat(new Body.While(DARK, RUN, OptionalInt.empty()).parts()).containsExactly(RUN);
    assertThat(new Body.ForEach(LAMP, DARK, FAIL).parts()).containsExactly(FAIL);
    assertThat(FAIL.parts()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "move | 1 | A STEP | \"move\"",
        "() | 1 | A STEP | \"()\"",
        "(achive (a)) | 1 | A STEP | \"(achive ...)\"",
        "(seq) | 5 | A STEP | \")\"",
        "(seq (achieve (a)) b) | 20 | A STEP | \"b\"",
        "(seq (achieve (a)) | 19 | the \")\" for the \"(\" at column 1 | the end of the text",
        "(if (a)) | 8 | a condition, a step, and perhaps another | \")\"",
        "(if (a) (run b) (run c) (run d)) | 25 | \")\" | \"(run ...)\"",
        "(while (a) (run b) :most) | 25 | :most and a number | \")\"",
        "(while (a) (run b) :least 3) | 20 | :most | \":least\"",
        "(while (a) (run b) :most 0) | 26 | a whole number above 0 | \"0\"",
        "(while (a) (run b) :most 1.5) | 26 | a whole number above 0 | \"1.5\"",
        "(foreach ?x (a) (run b)) | 10 | variables in parentheses such as (?x - Thing) | \"?x\"",
        "(foreach (?x ?y) (a) (run b)) | 10 | one variable in parentheses, such as (?x - Thing)"
            + " | \"(?x ...)\"",
        "(foreach (?x) (a)) | 18 | a variable, a condition and a step | \")\"",
        "(let x (value 1) (run b)) | 6 | a variable such as ?x | \"x\"",
        "(let ?x 1 (run b)) | 9 | A SOURCE | \"1\"",
        "(let ?x (all) (run b)) | 9 | A SOURCE | \"(all ...)\"",
        "(let ?x (value 1)) | 18 | A STEP | \")\"",
        "(try (run a)) | 13 | a step, and (recover ...) or (finally ...) | \")\"",
        "(try (run a) (run b)) | 14 | (recover ...) or (finally ...) | \"(run ...)\"",
        "(try (run a) (finally (run b)) (recover (run c))) | 32 | \")\" | \"(recover ...)\"",
        "(try (run a) (recover late (run b))) | 23 | a text in quotes | \"late\"",
        "(achieve) | 9 | a goal | \")\"",
        "(achieve (keep (a))) | 10 | \"keep\" only around a whole goal, and a formula"
            + " | \"(keep ...)\"",
        "(do move) | 9 | a feature and a member | \")\"",
        "(do move rose zone-a) | 15 | the name of a parameter, such as :to | \"zone-a\"",
        "(do move rose :to) | 18 | a term for :to | \")\"",
        "(do move rose :to a :to b) | 21 | each parameter once | \":to\"",
        "(do move rose :to (a)) | 19 | a term | \"(a ...)\"",
        "(run) | 5 | the name of a script | \")\"",
        "(run \"a\") | 6 | the name of a script | the string \"a\"",
        "(wait) | 6 | a condition or seconds | \")\"",
        "(wait long) | 7 | a number, a variable or a fluent in parentheses | \"long\"",
        "(say Bob) | 9 | A SENTENCE | \")\"",
        "(say Bob (a)) | 10 | a term | \"(a ...)\"",
        "(ask Bob \"Well?\") | 17 | A QUESTION | \")\"",
        "(ask Bob ?x Zone (a)) | 18 | A QUESTION | \"(a ...)\"",
        "(ask Bob \"Well?\" Zone Lamp) | 27 | A QUESTION | \")\"",
        "(ask Bob \"Well?\" ?x (a)) | 21 | A STEP | \"(a ...)\"",
        "(ask Bob \"Well?\" ?x (choice)) | 28 | OPTIONS | \")\"",
        "(ask Bob \"Well?\" ?x (choice (a))) | 29 | a term | \"(a ...)\"",
        "(ask Bob \"Well?\" ?x (slider 1 7)) | 32 | A RANGE | \")\"",
        "(ask Bob \"Well?\" ?x (slider 1 ?most 1)) | 31 | A RANGE | \"?most\"",
        "(ask Bob \"Well?\" ?x (slider 1 7 1 \"low\")) | 40 | A RANGE | \")\"",
        "(ask Bob \"Well?\" ?x (slider 1 7 1 low high)) | 35 | A RANGE | \"low\"",
        "(ask Bob \"Well?\" ?x (slider 1 7 1 \"a\" \"b\" \"c\")) | 43 | \")\" | the string \"c\"",
        "(ask Bob \"Well?\" ?x Zone (choice 1 2)) | 26 | A STEP | \"(choice ...)\"",
        "(tell CCA) | 10 | A MESSAGE | \")\"",
        "(tell CCA (ping) (ping)) | 18 | \")\" | \"(ping ...)\"",
        "(tell CCA ping) | 11 | a content element such as (initCNP ...) | \"ping\"",
        "(express glad) | 14 | a word and a number from 0 to 1, such as (express glad 0.8)"
            + " | \")\"",
        "(express glad 1 2) | 17 | \")\" | \"2\"",
        "(look) | 6 | a thing | \")\"",
        "(look (in Cup zone-a)) | 7 | a term | \"(in ...)\"",
        "(return) | 8 | a term | \")\"",
        "(fail no) | 7 | a text in quotes | \"no\"",
        "(fail \"no\") x | 13 | the end of the text | \"x\"",
      })
  void aFaultyBody(String text, int column, String expected, String found) {
    String whole =
        expected
            .replace(
                "A STEP", "a step, such as (achieve (in Cup zone-a)) or (do move rose :to zone-a)")
            .replace(
                "A SENTENCE",
                "a person or a room, and what is said, such as (say Bob \"The cup is in\" ?room)")
            .replace(
                "A QUESTION",
                "a person or a room, what is asked, a variable for the answer, and perhaps its"
                    + " class, such as (ask Bob \"Which room?\" ?room Zone)")
            .replace(
                "OPTIONS",
                "answers of which one is chosen, such as (choice \"good\" \"fair\" \"bad\")")
            .replace(
                "A RANGE",
                "the lowest number, the highest, the step, and perhaps what stands at both ends,"
                    + " such as (slider 1 7 1 \"not at all\" \"very\")")
            .replace(
                "A MESSAGE",
                "an agent and a message, such as (tell CCA (initCNP (:goal (in Cup zone-a))))")
            .replace(
                "A SOURCE",
                "what the variable stands for: (value (charge rose)), (one (?x - Thing) (in ?x"
                    + " zone-a)) or (run script ...)");
    assertThatThrownBy(() -> SlParser.body(text, name -> false))
        .isInstanceOf(SlSyntaxException.class)
        .hasMessage("At column %d %s was expected, but found %s.".formatted(column, whole, found));
  }
}
