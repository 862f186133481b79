package org.maestro.persons;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.persons.belief.Evidence;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Takes from the collective knowledge what is new of each cue, once: what a device goes on to say
 * counts again only when its errors are others. What a tracker itself has told, and what is only
 * expected, is none. Confined to one thread.
 */
final class CueWatch {
  /** What was seen before the watch began tells little of where somebody is now. */
  private static final Duration FRESH = Duration.ofSeconds(30);

  private static final String VIEW_SHARE = "viewShare";

  private final String tracker;
  private final Map<Formula.Atom, Counted> counted = new HashMap<>();

  /** What was told of a cue when it counted the last time, and when that was. */
  private record Counted(boolean so, Instant since, Instant at) {}

  /**
   * @param tracker as which source what is concluded is told
   */
  CueWatch(String tracker) {
    this.tracker = tracker;
  }

  /** What is news of these cues. */
  List<Evidence> news(List<CueSite> sites, Snapshot now) {
    List<Evidence> news = new ArrayList<>();
    for (CueSite site : sites) {
      Optional<Belief> told = told(site, now);
      if (told.isEmpty()) {
        counted.remove(site.fact());
      } else if (counts(site, told.get(), now.at())) {
        boolean so = isSo(site, told.get());
        counted.put(site.fact(), new Counted(so, told.get().since(), now.at()));
        news.add(evidence(site, told.get(), now));
      }
    }
    return news;
  }

  /** What was told of it last, by others than the tracker. */
  Optional<Belief> told(CueSite site, Snapshot now) {
    String fact = SlPrinter.print(site.fact());
    String denial = denial(fact);
    return now.claims(site.fact()).stream()
        .filter(belief -> belief.fact().equals(fact) || belief.fact().equals(denial))
        .filter(belief -> isFromOthers(belief.source()))
        .max(Comparator.comparing(Belief::since));
  }

  private boolean isFromOthers(Source source) {
    return !source.agent().equals(tracker)
        && (source.kind() == Source.Kind.STATED || source.kind() == Source.Kind.OBSERVED);
  }

  private static boolean isSo(CueSite site, Belief told) {
    return !told.fact().equals(denial(SlPrinter.print(site.fact())));
  }

  private static String denial(String fact) {
    return "(not " + fact + ")";
  }

  private boolean counts(CueSite site, Belief told, Instant now) {
    Counted before = counted.get(site.fact());
    Optional<Duration> again = site.cue().countsAgainAfter();
    if (before == null) {
      return again.isPresent() || !told.since().plus(FRESH).isBefore(now);
    }
    return before.so() != isSo(site, told)
        || again
            .map(time -> !before.at().plus(time).isAfter(now))
            .orElse(told.since().isAfter(before.since()));
  }

  private static Evidence evidence(CueSite site, Belief told, Snapshot now) {
    boolean so = isSo(site, told);
    Evidence evidence =
        new Evidence(site.person(), site.zone(), so, site.cue().hitRate(), site.cue().falseRate());
    return evidence.weakened(told.confidence() * (so ? 1 : seenShare(site, told, now)));
  }

  /** Who looks into a part of a zone only has seen nobody in that part. */
  private static double seenShare(CueSite site, Belief told, Snapshot now) {
    if (site.cue().isOfDevices()) {
      return 1;
    }
    if (told.coveredShare().isPresent()) {
      return told.coveredShare().getAsDouble();
    }
    OptionalDouble share =
        now.number(
            new Expression.Fluent(
                VIEW_SHARE,
                List.of(new Term.Name(told.source().agent()), new Term.Name(site.zone()))));
    return share.isPresent() && share.getAsDouble() > 0 ? share.getAsDouble() : 1;
  }
}
