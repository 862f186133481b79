package org.maestro.diary;

import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.api.Requester;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.PrivateWords;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/** Reads a person's day from the lines of a diary. For one thread, once. */
final class DayReading {
  private static final Duration LEAST_SILENCE = Duration.ofMinutes(1);

  /** What changes again so soon has not come to rest, as a timer that runs down. */
  private static final Duration ONE_RUN = Duration.ofSeconds(10);

  private final Noteworthy words;
  private final Home home;
  private final String person;
  private final Set<String> hidden;
  private final List<DayReport.Stay> stays = new ArrayList<>();
  private final List<DayReport.Silence> silences = new ArrayList<>();
  private final List<DayReport.Change> changes = new ArrayList<>();
  private final Map<String, Run> runs = new HashMap<>();
  private final Map<String, DayReport.Request> requests = new LinkedHashMap<>();
  private Optional<DayReport.Stay> present = Optional.empty();
  private Instant silentSince = Instant.MIN;
  private int leftOut;

  /**
   * @param hidden words of which nothing is told
   */
  DayReading(Noteworthy words, Home home, String person, Set<String> hidden) {
    this.words = words;
    this.home = home;
    this.person = person;
    this.hidden = hidden;
  }

  /**
   * @param from midnight
   * @param until the next one, or now
   */
  DayReport read(LocalDate date, List<DiaryLine> lines, Instant from, Instant until) {
    silentSince = from;
    Instant last = from;
    for (DiaryLine line : lines) {
      if (line instanceof DiaryLine.Begun) {
        // Where she was then she was as long as anybody has told anything at least.
        leave(last);
      } else if (line instanceof DiaryLine.Became became) {
        Noteworthy.read(became.fact()).ifPresent(fact -> take(fact, became));
      } else if (line instanceof DiaryLine.Asked asked) {
        take(asked);
      } else if (line instanceof DiaryLine.Over over) {
        requests.computeIfPresent(
            over.id(),
            (id, request) ->
                new DayReport.Request(
                    request.at(),
                    id,
                    request.goal(),
                    request.by(),
                    request.person(),
                    Optional.of(new DayReport.End(over.at(), over.end(), over.reason()))));
      }
      last = line.at();
    }
    present.ifPresentOrElse(stay -> leave(until), () -> silence(until));
    return new DayReport(
        person, date, until, stays, silences, changes, List.copyOf(requests.values()), leftOut);
  }

  private void take(Fact fact, DiaryLine.Became became) {
    Optional<Noteworthy.Whereabouts> where = words.whereabouts(fact);
    boolean isOfAnother = where.filter(it -> !it.person().equals(person)).isPresent();
    if (isOfAnother) {
      return;
    }
    if (hidden.contains(word(fact))) {
      leftOut++;
    } else if (where.isEmpty()) {
      change(words.subject(fact), became);
    } else if (fact instanceof Fact.Holds) {
      enter(where.get().zone(), became);
    } else {
      leave(became.at());
    }
  }

  /** What is told first of something is how it was; of what goes on and on, begin and end count. */
  private void change(String subject, DiaryLine.Became became) {
    DayReport.Change change = new DayReport.Change(became.at(), became.fact());
    Run run = Optional.ofNullable(runs.get(subject)).orElseGet(Run::new);
    if (runs.put(subject, run) == null) {
      run.fact = became.fact();
      return;
    }
    if (run.fact.equals(became.fact())) {
      return;
    }
    run.fact = became.fact();
    boolean goesOn =
        run.last
            .filter(last -> Duration.between(last.at(), change.at()).compareTo(ONE_RUN) <= 0)
            .isPresent();
    if (goesOn && run.isLong) {
      changes.remove(run.last.orElseThrow());
    }
    run.isLong = goesOn;
    run.last = Optional.of(change);
    changes.add(change);
  }

  /** The latest changes of one state variable. */
  private static final class Run {
    private String fact = "";
    private Optional<DayReport.Change> last = Optional.empty();

    /** Whether the one before the last came shortly before that. */
    private boolean isLong;
  }

  private static String word(Fact fact) {
    if (fact instanceof Fact.Equation equation) {
      Expression.Fluent fluent = equation.fluent();
      return fluent.name();
    }
    return Noteworthy.atom(fact).orElseThrow().predicate();
  }

  private void enter(String zone, DiaryLine.Became became) {
    Instant at = became.at();
    if (present.filter(stay -> stay.zone().equals(zone)).isPresent()) {
      return;
    }
    if (present.isEmpty() && isBack(zone, at)) {
      present = Optional.of(stays.remove(stays.size() - 1));
      return;
    }
    present.ifPresentOrElse(stay -> leave(at), () -> silence(at));
    present = Optional.of(new DayReport.Stay(zone, became.fact(), at, at));
  }

  /** Who is out of sight for a moment has not been away. */
  private boolean isBack(String zone, Instant at) {
    return !stays.isEmpty()
        && stays.get(stays.size() - 1).zone().equals(zone)
        && Duration.between(silentSince, at).compareTo(LEAST_SILENCE) < 0;
  }

  private void leave(Instant at) {
    present.ifPresent(
        stay -> {
          stays.add(new DayReport.Stay(stay.zone(), stay.fact(), stay.from(), at));
          silentSince = at;
        });
    present = Optional.empty();
  }

  private void silence(Instant until) {
    if (Duration.between(silentSince, until).compareTo(LEAST_SILENCE) >= 0) {
      silences.add(new DayReport.Silence(silentSince, until));
    }
  }

  private void take(DiaryLine.Asked asked) {
    if (isHidden(asked.goal())) {
      leftOut++;
      return;
    }
    Requester requester = Requester.parse(asked.requester());
    requests.put(
        asked.id(),
        new DayReport.Request(
            asked.at(),
            asked.id(),
            asked.goal(),
            requester.caller(),
            requester.person(),
            Optional.empty()));
  }

  /** What cannot be read any more is told to who may read everything. */
  private boolean isHidden(String goal) {
    if (hidden.isEmpty()) {
      return false;
    }
    try {
      return PrivateWords.of(home)
          .usedFor(SlParser.formula(goal, home.vocabulary()::isFluent))
          .stream()
          .anyMatch(hidden::contains);
    } catch (SlSyntaxException unreadable) {
      return true;
    }
  }
}
