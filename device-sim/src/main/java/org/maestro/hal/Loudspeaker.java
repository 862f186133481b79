package org.maestro.hal;

/** A loudspeaker with the synthesiser of speech before it (ADE, 4; A51). */
public interface Loudspeaker {

  /**
   * Says a sentence; the completion is told when all of it was heard.
   *
   * @param text of one sentence or a few
   */
  void say(String text, Completion completion);

  /** How long it takes to say this. */
  double seconds(String text);
}
