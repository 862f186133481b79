package org.maestro.coordination.api;

/**
 * An edge of the wait-for graph.
 *
 * @param goalId who waits
 * @param holder the goal that has the resource, counts on the fact, or comes before in the queue
 */
public record WaitsFor(String goalId, Resource resource, String holder) {

  /** For people. */
  public String inWords() {
    return switch (resource.kind()) {
      case FACT -> holder + " counts on it that " + resource.inWords();
      case END -> holder + " goes first";
      default -> resource.inWords() + " is held by " + holder;
    };
  }
}
