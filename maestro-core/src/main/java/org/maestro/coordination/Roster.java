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

  public void present(String member) {
    absenceByMember.put(member, Optional.empty());
  }

  public void absent(String member, String reason) {
    absenceByMember.put(member, Optional.of(reason));
  }

  public boolean isPresent(String member) {
    return absenceByMember.getOrDefault(member, Optional.of("")).isEmpty();
  }

  public String absence(String member) {
    return absenceByMember.getOrDefault(member, Optional.of("never joined")).orElse("present");
  }
}
