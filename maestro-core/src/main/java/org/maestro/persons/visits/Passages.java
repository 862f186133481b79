package org.maestro.persons.visits;

import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.knowledge.habits.HabitLog;
import org.maestro.knowledge.habits.LikeNow;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Counts passages, and tells where somebody will go next: by what she did within two hours of this
 * time of day, on days like today, when she had come the same way; where that was never seen,
 * whichever way she had come. Confined to one thread.
 */
public final class Passages {
  private static final Logger LOG = LoggerFactory.getLogger(Passages.class);
  private static final Duration ABOUT = Duration.ofHours(2);
  private static final Duration REMEMBERED = Duration.ofDays(60);

  /**
   * As one passage counts what is assumed before the first: that one way is as likely as another
   * (Perks 1947).
   */
  private static final double ASSUMED = 1;

  private final HabitLog log;
  private final List<Passage> passages = new ArrayList<>();

  /** A place to which somebody is likely to go, and how likely. */
  public record Next(String place, double probability) {}

  public Passages(HabitLog log) {
    this.log = log;
  }

  /** Takes up what was counted before; to be called once, before anything else. */
  public void begin(Instant now) {
    Instant oldest = now.minus(REMEMBERED);
    int number = 0;
    for (String line : log.lines()) {
      number++;
      Optional<Passage> passage = Passage.read(line);
      if (passage.isEmpty()) {
        LOG.warn("Line {} of the passages is passed over, as it cannot be read.", number);
      }
      passage.filter(one -> one.at().isAfter(oldest)).ifPresent(passages::add);
    }
  }

  /** Counts one. */
  public void add(Passage passage) {
    passages.add(passage);
    log.add(passage.line());
    Instant oldest = passage.at().minus(REMEMBERED);
    passages.removeIf(one -> one.at().isBefore(oldest));
  }

  /**
   * Where the person will go next, of all places the likeliest; empty when she is likelier to stay.
   *
   * @param from where she has come from
   * @param through where she has come to
   * @param ways how many ways lead on from there
   */
  public Optional<Next> next(
      String person, String from, String through, int ways, Instant now, ZoneId zone) {
    List<Passage> like =
        passages.stream()
            .filter(one -> one.person().equals(person) && one.through().equals(through))
            .filter(one -> LikeNow.are(one.at().atZone(zone), now.atZone(zone), ABOUT))
            .toList();
    List<Passage> sameWay = like.stream().filter(one -> one.from().equals(from)).toList();
    List<Passage> counted = sameWay.isEmpty() ? like : sameWay;
    Map<String, Integer> times = new TreeMap<>();
    counted.forEach(one -> times.merge(one.next(), 1, Integer::sum));
    return times.entrySet().stream()
        .max(Comparator.comparing(Map.Entry::getValue))
        .filter(most -> !most.getKey().equals(through))
        .map(
            most ->
                new Next(
                    most.getKey(),
                    (most.getValue() + ASSUMED / (ways + 1)) / (counted.size() + ASSUMED)));
  }
}
