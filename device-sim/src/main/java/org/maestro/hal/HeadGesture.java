package org.maestro.hal;

import java.util.Locale;

/** What a face does with its head (ADE, 4.2; A60). */
public enum HeadGesture {
  /** It agrees, or has understood. */
  NOD,
  /** It does not. */
  SHAKE;

  /** As it stands in reports. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
