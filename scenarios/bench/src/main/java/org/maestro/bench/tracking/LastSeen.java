package org.maestro.bench.tracking;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.knowledge.api.KnowledgeBase;

/** What ours is compared with: a person is where a camera has recognised her last. Any thread. */
final class LastSeen {
  private static final Pattern SEEN = Pattern.compile("\\(recognises (\\S+) (\\S+)\\)");

  private final Map<String, String> zoneByCamera;
  private final Map<String, String> zoneByPerson = new TreeMap<>();

  /**
   * It watches from now on.
   *
   * @param zoneByCamera where each camera looks
   */
  LastSeen(KnowledgeBase knowledge, Map<String, String> zoneByCamera) {
    this.zoneByCamera = Map.copyOf(zoneByCamera);
    knowledge.watch(change -> change.facts().forEach(this::hear));
  }

  private synchronized void hear(String fact) {
    Matcher seen = SEEN.matcher(fact);
    if (seen.matches() && zoneByCamera.containsKey(seen.group(1))) {
      zoneByPerson.put(seen.group(2), zoneByCamera.get(seen.group(1)));
    }
  }

  synchronized Optional<String> zone(String person) {
    return Optional.ofNullable(zoneByPerson.get(person));
  }
}
