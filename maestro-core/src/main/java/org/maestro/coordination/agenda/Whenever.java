package org.maestro.coordination.agenda;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.knowledge.Instances;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;

/**
 * Begins its goal each time that a condition becomes known to hold, once for each choice of
 * individuals, until it is cancelled.
 */
final class Whenever implements Vigil {
  /** Before the number of each instance of the condition that was ever so. */
  private static final String SO = "2.";

  /** Noted once it was looked at for the first time. */
  private static final String LOOKED = "3";

  /** What makes itself so and not so does not spin. */
  private static final Duration BETWEEN = Duration.ofSeconds(1);

  /** Who has come back after a restart tells of itself within this time. */
  private static final Duration TELLING = Duration.ofSeconds(1);

  private final Entry entry;
  private final Formula condition;
  private final Formula goal;
  private final Edges<Formula> edges = new Edges<>();
  private final Map<Formula, String> paths = new HashMap<>();

  /** Of what was so once, before a restart. */
  private final Deque<String> free = new ArrayDeque<>();

  private final Map<Formula, Duration> lately = new LinkedHashMap<>();
  private boolean isWatching;

  Whenever(Entry entry, Formula condition, Formula goal) {
    this.entry = entry;
    this.condition = condition;
    this.goal = goal;
  }

  @Override
  public void start() {
    List<Formula> already = edges.look(instances().all().keySet(), instances()::truth);
    if (!already.isEmpty()) {
      entry.tell(StoryEntry.Kind.KNOWN, "So already, which does not count: " + told(already) + ".");
    }
    writeDown(Set.of());
    entry.note(LOOKED, "so");
    await();
  }

  private void await() {
    isWatching = true;
    entry.awaits(SlPrinter.print(condition) + " to become so");
  }

  private Instances instances() {
    return new Instances(condition, entry.known());
  }

  @Override
  public void takeUp() {
    if (entry.note(LOOKED).isEmpty()) {
      start();
      return;
    }
    entry
        .texts(SO)
        .forEach(
            (path, text) ->
                text.map(so -> SlParser.formula(so, entry.vocabulary()::isFluent))
                    .ifPresentOrElse(so -> paths.put(so, path), () -> free.add(path)));
    edges.resume(paths.keySet());
    entry.unborn().ifPresent(id -> entry.missed("what was to be begun as " + id));
    entry.awaits(SlPrinter.print(condition) + " to become so");
    entry.at(entry.now().plus(TELLING), this::lookAfterRestart);
  }

  private void lookAfterRestart() {
    Set<Formula> before = edges.so();
    List<Formula> since = edges.look(instances().all().keySet(), instances()::truth);
    writeDown(before);
    if (!since.isEmpty()) {
      entry.missed(told(since) + " became so");
    }
    await();
  }

  @Override
  public void knowledgeChanged(FactFilter changed) {
    if (isWatching && FactFilter.ofReading(condition, entry.vocabulary()).isConcernedBy(changed)) {
      look();
    }
  }

  @Override
  public void memberLost() {
    if (isWatching) {
      edges.lost(instances()::truth);
    }
  }

  private void look() {
    Duration now = entry.now();
    lately.values().removeIf(at -> at.plus(BETWEEN).compareTo(now) <= 0);
    Set<Formula> before = edges.so();
    Map<Formula, Substitution> holding = instances().all();
    List<Formula> become = edges.look(holding.keySet(), instances()::truth);
    List<Formula> begun = become.stream().filter(one -> !lately.containsKey(one)).toList();
    putOff(become.stream().filter(lately::containsKey).toList());
    writeDown(before);
    for (Formula one : begun) {
      lately.put(one, now);
      Substitution instance = Optional.ofNullable(holding.get(one)).orElseThrow();
      entry.begin(
          instance.apply(goal), "because " + SlPrinter.print(one) + " became so", why -> {});
    }
    if (!begun.isEmpty()) {
      await();
    }
  }

  private void putOff(List<Formula> tooSoon) {
    tooSoon.forEach(edges::putOff);
    tooSoon.stream()
        .flatMap(one -> Optional.ofNullable(lately.get(one)).stream())
        .min(Comparator.naturalOrder())
        .ifPresent(begun -> entry.at(begun.plus(BETWEEN), this::look));
  }

  /** What is so now and was not, or the other way round. */
  private void writeDown(Set<Formula> before) {
    Set<Formula> so = edges.so();
    before.stream()
        .filter(one -> !so.contains(one))
        .forEach(one -> entry.note(path(one), Optional.empty(), Optional.empty()));
    so.stream()
        .filter(one -> !before.contains(one))
        .forEach(one -> entry.note(path(one), SlPrinter.print(one)));
  }

  private String path(Formula one) {
    return paths.computeIfAbsent(
        one, another -> free.isEmpty() ? SO + (paths.size() + 1) : free.removeFirst());
  }

  private static String told(Collection<Formula> instances) {
    return instances.stream().map(SlPrinter::print).collect(Collectors.joining(", "));
  }
}
