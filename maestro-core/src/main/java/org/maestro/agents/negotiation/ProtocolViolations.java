package org.maestro.agents.negotiation;

/** Is told when an agent does not keep to the rules of a conversation about a goal. */
public interface ProtocolViolations {

  /**
   * @param sentence who did what, and what is made of it; without a full stop
   */
  void noted(String goalId, String sentence);
}
