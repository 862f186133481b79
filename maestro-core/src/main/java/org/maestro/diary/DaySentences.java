package org.maestro.diary;

import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.wording.FactWords;
import org.maestro.language.wording.GoalWords;
import org.maestro.language.wording.Naming;
import org.maestro.language.wording.Wish;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/**
 * A day in sentences, without ids. What there are no words for is told by the names of its things.
 */
public final class DaySentences {
  private final Home home;
  private final ZoneId zone;
  private final Grammar grammar;
  private final FactWords facts;
  private final GoalWords goals;
  private final Naming naming;

  /**
   * @param zone of the home's clocks
   */
  public DaySentences(Home home, ZoneId zone, Grammar grammar) {
    this.home = home;
    this.zone = zone;
    this.grammar = grammar;
    this.facts = new FactWords(home, grammar, Optional.empty());
    this.goals = new GoalWords(home, grammar, Optional.empty());
    this.naming = new Naming(home, grammar);
  }

  /**
   * A sentence of a day, with the time that the home's clocks showed.
   *
   * @param to when it was over; empty: it has no length
   */
  public record Told(LocalTime from, Optional<LocalTime> to, String text) {}

  private record Dated(Instant at, Told told) {}

  /** All of it, in the order of time. */
  public List<Told> of(DayReport report) {
    List<Dated> all = new ArrayList<>();
    for (DayReport.Stay stay : report.stays()) {
      all.add(during(stay.from(), stay.to(), fact(stay.fact())));
    }
    for (DayReport.Silence silence : report.silences()) {
      all.add(
          during(
              silence.from(),
              silence.to(),
              with("day-silence", Map.of("who", naming.word(report.person())))));
    }
    // Of one moment the wish comes before what is done for it, and that before its end.
    report.requests().forEach(request -> all.add(at(request.at(), asked(request))));
    report.changes().forEach(change -> all.add(at(change.at(), fact(change.fact()))));
    report
        .requests()
        .forEach(
            request -> request.end().ifPresent(end -> all.add(at(end.at(), ended(request, end)))));
    return all.stream().sorted(Comparator.comparing(Dated::at)).map(Dated::told).toList();
  }

  private Dated during(Instant from, Instant to, String text) {
    return new Dated(from, new Told(time(from), Optional.of(time(to)), text));
  }

  private Dated at(Instant at, String text) {
    return new Dated(at, new Told(time(at), Optional.empty(), text));
  }

  private LocalTime time(Instant at) {
    return at.atZone(zone).toLocalTime().truncatedTo(ChronoUnit.SECONDS);
  }

  private String fact(String text) {
    return Noteworthy.read(text)
        .flatMap(this::formula)
        .flatMap(facts::sentence)
        .orElseGet(() -> naming.inText(text));
  }

  private Optional<Formula> formula(Fact fact) {
    if (fact instanceof Fact.Equation equation) {
      return Optional.of(
          new Formula.Comparison(
              Formula.Relation.EQUAL, equation.fluent(), new Expression.OfTerm(equation.value())));
    } else if (fact instanceof Fact.Excluded excluded) {
      return Optional.of(new Formula.Not(excluded.atom()));
    }
    return fact instanceof Fact.Holds holds ? Optional.of(holds.atom()) : Optional.empty();
  }

  private Wish wish(DayReport.Request request) {
    return new Wish(goal(request), Optional.empty(), request.person(), Duration.ZERO);
  }

  private Optional<Formula> goal(DayReport.Request request) {
    try {
      return Optional.of(SlParser.formula(request.goal(), home.vocabulary()::isFluent));
    } catch (SlSyntaxException unreadable) {
      return Optional.empty();
    }
  }

  private String asked(DayReport.Request request) {
    String deed =
        goals
            .deed(wish(request))
            .or(() -> goal(request).flatMap(this::script))
            .orElseGet(() -> naming.inText(request.goal()));
    return request
        .person()
        .map(person -> with("day-asked-by", Map.of("who", naming.word(person), "deed", deed)))
        .orElseGet(() -> with("day-asked", Map.of("deed", deed)));
  }

  /** What a script is for, as its home says it. */
  private Optional<String> script(Formula goal) {
    return goal instanceof Formula.Atom atom
        ? Optional.ofNullable(home.scripts().get(atom.predicate()))
            .map(Script::label)
            .filter(label -> !label.isBlank())
        : Optional.empty();
  }

  private String ended(DayReport.Request request, DayReport.End end) {
    return switch (end.how()) {
      case "reached", "unseen" ->
          with(
              "day-reached",
              Map.of("fact", goals.reached(goal(request), end.how().equals("reached"))));
      case "cancelled" -> goals.calledOff(wish(request));
      default -> goals.failed(wish(request), List.of(end.reason()));
    };
  }

  private String with(String phrase, Map<String, String> values) {
    String text = grammar.phrase(phrase);
    for (Map.Entry<String, String> value : values.entrySet()) {
      text = text.replace("{" + value.getKey() + "}", value.getValue());
    }
    return text;
  }
}
