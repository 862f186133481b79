package org.maestro.platform.guard;

import java.io.ObjectInputFilter;

/**
 * Lets only such classes be deserialised in this process as containers send each other. JADE's
 * streams take anything; there is one filter for all streams of a process. Thread-safe.
 */
public final class SerialFilter implements ObjectInputFilter {
  private static final String ALLOWED =
      String.join(
          ";",
          "maxdepth=50",
          "maxrefs=500000",
          "maxarray=1000000",
          "maxbytes=16000000",
          "jade.**",
          "org.maestro.**",
          "java.lang.*",
          "java.math.*",
          "java.time.*",
          "java.util.*",
          "java.util.concurrent.*",
          "java.util.concurrent.atomic.*",
          "!*");

  private final ObjectInputFilter allowed = ObjectInputFilter.Config.createFilter(ALLOWED);
  private final Refusals refusals = new Refusals();

  /** Once there is a filter, also one that was named at the start of Java, it stays. */
  public static synchronized void install() {
    if (ObjectInputFilter.Config.getSerialFilter() == null) {
      ObjectInputFilter.Config.setSerialFilter(new SerialFilter());
    }
  }

  @Override
  public Status checkInput(FilterInfo info) {
    Status status = allowed.checkInput(info);
    if (status == Status.REJECTED) {
      refusals.log(
          info.serialClass() == null
              ? "What was sent to be deserialised is too large, and was refused."
              : "What was sent to be deserialised was refused: agents need no %s."
                  .formatted(info.serialClass().getName()));
    }
    return status;
  }
}
