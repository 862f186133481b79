package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.DayOfWeek;
import java.time.LocalDate;
import java.time.LocalTime;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Goals that are bound to a time or an event. */
class OccasionSyntaxTest {
  private static final Formula GOOD_NIGHT = new Formula.Atom("goodNight", List.of());

  @Test
  void timesComeOnceOrAgain() {
    assertThat(SlParser.formula("(at \"22:30\" (goodNight))"))
        .isEqualTo(at(Optional.empty(), LocalTime.of(22, 30), Set.of()));
    assertThat(SlParser.formula("(at \"2026-12-24 18:00:30\" (goodNight))"))
        .isEqualTo(at(Optional.of(LocalDate.of(2026, 12, 24)), LocalTime.of(18, 0, 30), Set.of()));
    assertThat(SlParser.formula("(at \"07:00\" :every \"friday, Monday\" (goodNight))"))
        .isEqualTo(
            at(Optional.empty(), LocalTime.of(7, 0), Set.of(DayOfWeek.MONDAY, DayOfWeek.FRIDAY)));
    assertThat(SlParser.formula("(at \"07:00\" :on \"friday\" (goodNight))"))
        .isEqualTo(
            new Formula.Upon(
                new Occasion.At(
                    Optional.empty(), LocalTime.of(7, 0), Set.of(DayOfWeek.FRIDAY), false),
                GOOD_NIGHT));
    assertThat(SlPrinter.print(SlParser.formula("(at \"07:00\" :every \"day\" (goodNight))")))
        .isEqualTo("(at \"07:00\" :every \"day\" (goodNight))");
  }

  private static Formula at(Optional<LocalDate> date, LocalTime time, Set<DayOfWeek> every) {
    return new Formula.Upon(new Occasion.At(date, time, every, !every.isEmpty()), GOOD_NIGHT);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "(at rose zone-a)",
        "(after rose tim)",
        "(until Bob)",
        "(whenever)",
        "(and (at rose zone-a) (after rose tim))"
      })
  void theirWordsMayBePredicatesAllTheSame(String atom) {
    assertThat(SlParser.formula(atom)).isNotInstanceOf(Formula.Bound.class);
    assertThat(SlPrinter.print(SlParser.formula(atom))).isEqualTo(atom);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(at \"25:00\" (x))|5|a time in quotes, such as \"22:30\"",
        "(at \"2026-02-30 10:00\" (x))|5|a time in quotes, such as \"22:30\"",
        "(at \"soon\" (x))|5|a time in quotes, such as \"22:30\"",
        "(at soon (x))|5|a time in quotes, such as \"22:30\"",
        "(at \"22:30\")|12|a time in quotes, such as \"22:30\" or \"2026-12-24 18:00\", and a goal",
        "(at \"22:30\" :each \"day\" (x))|13|:every, :on or a goal",
        "(at \"22:30\" :on \"day\" (x))|17|days of the week in quotes, such as \"Friday\"",
        "(at \"22:30\" :every \"noon\" (x))|20|\"day\", or days of the week in quotes",
        "(at \"2026-12-24 18:00\" :every \"day\" (x))|5|a time without a date before :every",
        "(after -1 (x))|8|seconds, a number from 0",
        "(after \"1\" (x))|8|seconds, a number from 0",
        "(whenever (open d))|19|a condition and a goal",
        "(until \"26:00\" (keep (open d)))|8|a time in quotes",
        "(and (at \"22:30\" (x)) (y))|6|\"at\" only around a whole goal",
      })
  void whatIsWrongIsToldWithItsPlace(String text, int column, String expected) {
    assertThatThrownBy(() -> SlParser.formula(text))
        .isInstanceOf(SlSyntaxException.class)
        .hasMessageContaining(expected)
        .extracting(e -> ((SlSyntaxException) e).column())
        .isEqualTo(column);
  }

  @Test
  void theyAreReadInMessages() {
    String text = "(initCNP (:goal (at \"22:30\" (until 60 (keep (open d))))) (:priority 2))";

    List<Content> read = SlParser.content(text);

    assertThat(SlPrinter.print(read)).isEqualTo(text);
    assertThat(((Content.Argument.Named) read.get(0).arguments().get(0)).arguments().get(0))
        .isInstanceOf(Content.Argument.OfFormula.class);
  }

  @Test
  void whatTheEventBindsIsPutIntoTheGoal() {
    Formula bound = SlParser.formula("(until (cold ?h) (after 60 (keep (not (hot ?h)))))");

    assertThat(FreeVariables.of(bound)).containsExactly("h");
    assertThat(SlPrinter.print(new Substitution(Map.of("h", new Term.Name("hob-1"))).apply(bound)))
        .isEqualTo("(until (cold hob-1) (after 60 (keep (not (hot hob-1)))))");
  }

  @Test
  void howItIsUnderstood() {
    assertThat(Outline.of(SlParser.formula("(whenever (open ?d) (after 60 (closed ?d)))")))
        .extracting(line -> line.depth() + " " + line.text() + ": " + line.role())
        .startsWith(
            "0 (whenever (open ?d) ...): each time that the first becomes so, the goal",
            "1 open: holds");
  }

  @Property(tries = 200)
  void thePrinterIsTheParsersInverse(@ForAll("bound") Formula bound) {
    assertThat(SlParser.formula(SlPrinter.print(bound), SyntaxTrees::isFluent)).isEqualTo(bound);
  }

  @Provide
  Arbitrary<Formula> bound() {
    Arbitrary<LocalTime> times =
        Arbitraries.integers().between(0, 86_399).map(LocalTime::ofSecondOfDay);
    Arbitrary<Occasion> once =
        Combinators.combine(
                Arbitraries.integers().between(0, 40_000).map(LocalDate::ofEpochDay).optional(),
                times)
            .as(Occasion.At::once);
    Arbitrary<Occasion> again =
        Combinators.combine(
                times,
                Arbitraries.of(DayOfWeek.class).set().ofMinSize(1),
                Arbitraries.of(true, false))
            .as((time, days, each) -> new Occasion.At(Optional.empty(), time, days, each));
    Arbitrary<Occasion> after =
        Arbitraries.integers().between(0, 1_000_000).map(n -> new Occasion.After(n / 4.0));
    Arbitrary<Occasion> first = SyntaxTrees.formulas().map(f -> new Occasion.Event(f, false));
    Arbitrary<Occasion> each = SyntaxTrees.formulas().map(f -> new Occasion.Event(f, true));
    Arbitrary<Formula> goals =
        Arbitraries.oneOf(SyntaxTrees.formulas(), SyntaxTrees.formulas().map(Formula.Keep::new));
    return Arbitraries.recursive(
        () -> goals,
        inner ->
            Arbitraries.oneOf(
                Combinators.combine(Arbitraries.oneOf(once, again, after, first, each), inner)
                    .as(Formula.Upon::new),
                Combinators.combine(Arbitraries.oneOf(once, after, first), inner)
                    .as(Formula.Until::new)),
        1,
        3);
  }
}
