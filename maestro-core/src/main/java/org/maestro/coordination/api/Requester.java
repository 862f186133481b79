package org.maestro.coordination.api;

import java.util.Optional;

/**
 * Who asks for a goal, as it is written down with the goal: {@code desk for Tom}.
 *
 * @param caller an agent's name, with that of its user where there is one
 * @param person of the home for whom it asks
 */
public record Requester(String caller, Optional<String> person) {
  private static final String FOR = " for ";

  /** What {@link #toString} wrote. */
  public static Requester parse(String text) {
    int at = text.lastIndexOf(FOR);
    return at < 0
        ? new Requester(text, Optional.empty())
        : new Requester(text.substring(0, at), Optional.of(text.substring(at + FOR.length())));
  }

  @Override
  public String toString() {
    return person.map(name -> caller + FOR + name).orElse(caller);
  }
}
