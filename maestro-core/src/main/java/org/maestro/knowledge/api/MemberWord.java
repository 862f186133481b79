package org.maestro.knowledge.api;

import java.util.List;

/**
 * All that a member said of itself in one message.
 *
 * @param facts ground MAESTRO-SL facts
 */
public record MemberWord(List<String> facts, Moment moment) {

  public MemberWord {
    facts = List.copyOf(facts);
  }
}
