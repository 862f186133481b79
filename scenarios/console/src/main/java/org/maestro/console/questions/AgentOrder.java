package org.maestro.console.questions;

import java.util.List;
import java.util.Optional;

/**
 * An order that changes which agents there are, where they live, or by what they go (Three-layered
 * architecture, 3.3.2; M68).
 */
public sealed interface AgentOrder {

  /**
   * Agents for the devices that a text describes.
   *
   * @param description Turtle, as in a home file
   * @param file a name for it in messages
   * @param as one agent of that name for all of them; empty: each has its own
   * @param container where; empty: where their topic lives
   * @param needs what their host has to provide
   */
  record Add(
      String description,
      String file,
      Optional<String> as,
      Optional<String> container,
      List<String> needs)
      implements AgentOrder {
    public Add {
      needs = List.copyOf(needs);
    }
  }

  /** To another container, when nothing is under way with it. */
  record Move(String agent, String to) implements AgentOrder {}

  /** By another description of its device. */
  record Reconfigure(String agent, String description, String file) implements AgentOrder {}

  /** Its device gets no other until one is added. */
  record Remove(String agent) implements AgentOrder {}
}
