package org.maestro.knowledge.api;

import java.util.List;
import java.util.Set;

/**
 * All that a member said of itself in one message, or what of it may be told before the rest.
 *
 * @param facts ground MAESTRO-SL facts
 * @param only the predicates and numbers of which it is told; empty: of all
 */
public record MemberWord(List<String> facts, Moment moment, Set<String> only) {

  public MemberWord {
    facts = List.copyOf(facts);
    only = Set.copyOf(only);
  }

  /** All that it said. */
  public MemberWord(List<String> facts, Moment moment) {
    this(facts, moment, Set.of());
  }

  public boolean isOf(String predicate) {
    return only.isEmpty() || only.contains(predicate);
  }

  public boolean isWhole() {
    return only.isEmpty();
  }
}
