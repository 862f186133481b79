package org.maestro.coordination;

import java.time.Duration;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Which members have an agent that can be asked, and why the others cannot. Owned by the
 * coordinator's thread.
 */
public final class Roster {
  private final SortedMap<String, Optional<String>> absenceByMember = new TreeMap<>();
  private final SortedMap<String, Optional<String>> lifeByMember = new TreeMap<>();
  private final SortedMap<String, Duration> lostByMember = new TreeMap<>();

  public void present(String member) {
    present(member, Optional.empty());
  }

  /**
   * @param life names the life that the member lives now, and the way in which it is called
   */
  public void present(String member, Optional<String> life) {
    absenceByMember.put(member, Optional.empty());
    lifeByMember.put(member, life);
  }

  public void absent(String member, String reason) {
    absenceByMember.put(member, Optional.of(reason));
    lostByMember.remove(member);
  }

  /**
   * @param at when the member was lost, by the coordinator's clock
   */
  public void absent(String member, String reason, Duration at) {
    absent(member, reason);
    lostByMember.put(member, at);
  }

  /** Why the member cannot be counted on, and since when: {@code lost since 12 s: no power}. */
  public String absence(String member, Duration now) {
    Duration lost = lostByMember.get(member);
    return lost == null
        ? absence(member)
        : "lost since " + now.minus(lost).toSeconds() + " s: " + absence(member);
  }

  public boolean isPresent(String member) {
    return absenceByMember.getOrDefault(member, Optional.of("")).isEmpty();
  }

  /** The life that a present member lives; empty when nobody told it. */
  public Optional<String> life(String member) {
    return isPresent(member)
        ? lifeByMember.getOrDefault(member, Optional.empty())
        : Optional.empty();
  }

  public String absence(String member) {
    return absenceByMember.getOrDefault(member, Optional.of("never joined")).orElse("present");
  }
}
