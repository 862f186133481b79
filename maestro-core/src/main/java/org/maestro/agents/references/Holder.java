package org.maestro.agents.references;

/** Who has asked for a reference. Told on the agent's thread. */
public interface Holder {
  /** The one that was asked for has accepted: from now on nobody is between the two. */
  void referred(Reference reference);

  /**
   * There is none; told instead of {@link #referred}.
   *
   * @param reason one sentence
   */
  void refused(String reason);

  /**
   * The one referred to is not there any more, or cannot be reached; told once.
   *
   * @param reason one sentence
   */
  void lost(Reference reference, String reason);
}
