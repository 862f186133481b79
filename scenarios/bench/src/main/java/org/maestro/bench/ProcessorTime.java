package org.maestro.bench;

import java.lang.management.ManagementFactory;

/** The processor time that this process has taken since it began. */
public final class ProcessorTime {
  private static final double NANOS = 1e9;

  private ProcessorTime() {}

  /** Seconds, of all its threads; NaN where Java does not tell. */
  public static double seconds() {
    return ManagementFactory.getOperatingSystemMXBean()
            instanceof com.sun.management.OperatingSystemMXBean system
        ? system.getProcessCpuTime() / NANOS
        : Double.NaN;
  }
}
