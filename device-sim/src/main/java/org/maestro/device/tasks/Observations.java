package org.maestro.device.tasks;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.maestro.rats.member.Execution;

/** The looks of one device that are under way, by what they look for. Clock thread only. */
final class Observations {

  private final Map<String, List<Execution>> byObject = new TreeMap<>();

  void add(String object, Execution execution) {
    byObject.values().forEach(running -> running.removeIf(Execution::ended));
    byObject.computeIfAbsent(object, name -> new ArrayList<>()).add(execution);
  }

  void end(String object) {
    List<Execution> running = byObject.remove(object);
    if (running != null) {
      running.forEach(execution -> execution.succeed(Map.of()));
    }
  }
}
