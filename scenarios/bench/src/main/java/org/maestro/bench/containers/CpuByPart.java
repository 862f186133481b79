package org.maestro.bench.containers;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Predicate;
import org.maestro.bench.ProcessorTime;

/**
 * The processor time that each part of a platform's process takes, by the names of its threads.
 * Threads that have ended, and those of Java itself, count among the rest.
 */
final class CpuByPart {
  static final String BROKER = "the broker";
  static final String CENTRE = "the central agent and its planning";
  static final String PAGES = "white and yellow pages (AMS, DF)";
  static final String STORE = "knowledge and store";
  static final String CLOCK = "the clock: links, news of members";
  static final String REST = "the rest: transport between containers, devices, Java";

  private static final double NANOS = 1e9;

  private static final Map<String, Predicate<String>> PARTS = parts();

  private final double processSeconds;
  private final Map<String, Double> secondsByPart;

  private CpuByPart(double processSeconds, Map<String, Double> secondsByPart) {
    this.processSeconds = processSeconds;
    this.secondsByPart = secondsByPart;
  }

  private static Map<String, Predicate<String>> parts() {
    Map<String, Predicate<String>> parts = new LinkedHashMap<>();
    parts.put(BROKER, name -> name.contains("activemq"));
    parts.put(CENTRE, List.of("CCA", "planning", "desk")::contains);
    parts.put(PAGES, List.of("ams", "df")::contains);
    parts.put(STORE, name -> name.startsWith("knowledge"));
    parts.put(CLOCK, name -> name.equals("maestro-clock") || name.endsWith("-maestro"));
    return parts;
  }

  static CpuByPart now() {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    Map<String, Double> seconds = new LinkedHashMap<>();
    PARTS.keySet().forEach(part -> seconds.put(part, 0.0));
    for (ThreadInfo thread : threads.getThreadInfo(threads.getAllThreadIds())) {
      if (thread != null) {
        long nanos = threads.getThreadCpuTime(thread.getThreadId());
        PARTS.forEach(
            (part, belongs) -> {
              if (nanos > 0 && belongs.test(thread.getThreadName())) {
                seconds.merge(part, nanos / NANOS, Double::sum);
              }
            });
      }
    }
    return new CpuByPart(ProcessorTime.seconds(), seconds);
  }

  /** Seconds of processor time since then, by part; the rest is the last. */
  Map<String, Double> since(CpuByPart before) {
    Map<String, Double> since = new LinkedHashMap<>();
    double parts = 0;
    for (Map.Entry<String, Double> part : secondsByPart.entrySet()) {
      double then = Objects.requireNonNull(before.secondsByPart.get(part.getKey()));
      double taken = Math.max(0, part.getValue() - then);
      since.put(part.getKey(), taken);
      parts += taken;
    }
    since.put(REST, Math.max(0, processSeconds - before.processSeconds - parts));
    return since;
  }
}
