package org.maestro.agents.runtime;

import java.util.Optional;

/**
 * The agents that speak for members and groups: nobody else is believed what he says of one (ADE,
 * 3.1; A23). Any thread may ask.
 */
public interface Spokesmen {
  /** Of agents that are each called as what they stand for. */
  Spokesmen BY_NAME =
      new Spokesmen() {
        @Override
        public Optional<String> objection(Caller caller, String subject) {
          return caller.agent().equals(subject)
              ? Optional.empty()
              : Optional.of(notItsOwn(caller, subject));
        }

        @Override
        public boolean isOwn(Caller caller) {
          return true;
        }
      };

  /**
   * Why the caller is not believed what it says.
   *
   * @param subject a member or a group, by its id
   * @return empty when it is
   */
  Optional<String> objection(Caller caller, String subject);

  /** Whether the caller is an agent of the platform's own: it speaks for some, or for all. */
  boolean isOwn(Caller caller);

  static String notItsOwn(Caller caller, String subject) {
    return "%s does not speak for %s; its own agent does.".formatted(caller, subject);
  }
}
