package org.maestro.coordination.api;

import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * The members whose agent can be asked, and the reasons why the others cannot. One in doubt is
 * there as far as anybody knows, and is not counted on until that is certain. Owned by the
 * coordinator's thread.
 */
public final class Roster {
  private final SortedMap<String, Optional<String>> absenceByMember = new TreeMap<>();
  private final SortedMap<String, String> doubtByMember = new TreeMap<>();
  private final SortedMap<String, Optional<String>> lifeByMember = new TreeMap<>();
  private final SortedMap<String, Duration> lostByMember = new TreeMap<>();
  private final SortedMap<String, Duration> arrivingByMember = new TreeMap<>();

  public void present(String member) {
    present(member, Optional.empty());
  }

  /**
   * @param life names the life that the member lives now, and the way in which it is called
   */
  public void present(String member, Optional<String> life) {
    arrivingByMember.remove(member);
    absenceByMember.put(member, Optional.empty());
    doubtByMember.remove(member);
    lifeByMember.put(member, life);
  }

  public void absent(String member, String reason) {
    absenceByMember.put(member, Optional.of(reason));
    doubtByMember.remove(member);
    lostByMember.remove(member);
    arrivingByMember.remove(member);
  }

  /**
   * A member has described itself. If nothing was heard of it before, its agent is still to come.
   *
   * @param at when it was, by the coordinator's clock
   */
  public void described(String member, Duration at) {
    if (!absenceByMember.containsKey(member)) {
      absent(member, "its agent is still to come");
      arrivingByMember.put(member, at);
    }
  }

  /**
   * @param at when the member was lost, by the coordinator's clock
   */
  public void absent(String member, String reason, Duration at) {
    absent(member, reason);
    lostByMember.put(member, at);
  }

  /**
   * A present member is not counted on for a while.
   *
   * @return whether the member is present
   */
  public boolean doubt(String member, String reason) {
    boolean there = isThere(member);
    if (there) {
      doubtByMember.put(member, reason);
    }
    return there;
  }

  /** Returns whether it was in doubt. */
  public boolean trust(String member) {
    return doubtByMember.remove(member) != null;
  }

  /** Why members that may be there are not counted on now, by member. */
  public SortedMap<String, String> doubts() {
    return new TreeMap<>(doubtByMember);
  }

  /** Why the member cannot be counted on, and since when: {@code lost since 12 s: no power}. */
  public String absence(String member, Duration now) {
    Duration lost = lostByMember.get(member);
    return lost == null || isThere(member)
        ? absence(member)
        : "lost since " + now.minus(lost).toSeconds() + " s: " + absence(member);
  }

  /** Members that were there and have not come back. */
  public Set<String> lost() {
    Set<String> lost = new TreeSet<>(lostByMember.keySet());
    lost.removeIf(this::isThere);
    return lost;
  }

  /** Whether it was there, and has not come back. */
  public boolean isLost(String member) {
    return lostByMember.containsKey(member) && !isThere(member);
  }

  /** Members that may be there soon: lost, or described for the first time, later than that. */
  public Set<String> expectedSince(Duration time) {
    Set<String> expected = lost();
    expected.addAll(arrivingByMember.keySet());
    expected.removeIf(
        member -> expectedFrom(member).filter(at -> at.compareTo(time) > 0).isEmpty());
    return expected;
  }

  /** When it was lost last, or described for the first time, as far as that is known. */
  public Optional<Duration> expectedFrom(String member) {
    return Optional.ofNullable(lostByMember.get(member))
        .or(() -> Optional.ofNullable(arrivingByMember.get(member)));
  }

  public boolean isPresent(String member) {
    return isThere(member) && !doubtByMember.containsKey(member);
  }

  /** Whether it is there, or may be. */
  public boolean isThere(String member) {
    return absenceByMember.getOrDefault(member, Optional.of("")).isEmpty();
  }

  /** The life that a present member lives; empty when nobody told it. */
  public Optional<String> life(String member) {
    return isThere(member) ? lifeByMember.getOrDefault(member, Optional.empty()) : Optional.empty();
  }

  public String absence(String member) {
    String doubt = doubtByMember.get(member);
    return doubt != null
        ? doubt
        : absenceByMember.getOrDefault(member, Optional.of("never joined")).orElse("present");
  }
}
