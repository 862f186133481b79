package org.maestro.console.access;

/**
 * A person's session in a browser.
 *
 * @param token by which it is known; whoever has it is that person
 * @param csrf which a page sends beside it where something is changed
 */
public record Session(String token, String person, String csrf) {
  @Override
  public String toString() {
    return "a session of " + person;
  }
}
