package org.maestro.experiment.setting;

/** An experiment was asked for in a way that makes no sense; the message is one sentence. */
public final class SettingException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public SettingException(String sentence) {
    super(sentence);
  }
}
