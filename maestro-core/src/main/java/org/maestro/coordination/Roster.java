package org.maestro.coordination;

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
