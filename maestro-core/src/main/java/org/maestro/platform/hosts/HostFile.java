package org.maestro.platform.hosts;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.deployment.Deployment;
import org.maestro.deployment.Provision;

/**
 * Reads which hosts belong to a platform:
 *
 * <pre>
 * {"hosts": [{"name": "attic", "topics": ["robots"], "provides": ["radio", "memory 512"],
 *             "command": ["ssh", "pi@attic", "maestro/maestro", "container", "--main", "{main}",
 *                         "--name={name}", "--topic={topics}", "--provides={provides}"]}]}
 * </pre>
 */
public final class HostFile {
  private static final Set<String> KNOWN =
      new TreeSet<>(List.of("command", "name", "provides", "topics"));

  private HostFile() {}

  /**
   * @param text of the file
   * @param source how faults call it
   * @param usual the command of a host that names none: a process on this machine
   * @throws IllegalArgumentException with one sentence: where, what, and what to do
   */
  public static List<HostStart> read(String text, String source, List<String> usual) {
    List<HostStart> hosts = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (JsonNode one : list(text, source)) {
      HostStart host = host(one, source, usual);
      if (!names.add(host.name())) {
        throw fault(source, "there are two hosts named " + host.name() + "; give one another name");
      }
      hosts.add(host);
    }
    return hosts;
  }

  private static JsonNode list(String text, String source) {
    try {
      JsonNode hosts = new ObjectMapper().readTree(text).path("hosts");
      if (!hosts.isArray() || hosts.isEmpty()) {
        throw fault(source, "it names no hosts; write {\"hosts\": [{\"name\": \"attic\"}]}");
      }
      return hosts;
    } catch (JsonProcessingException e) {
      throw fault(
          source + ", line " + e.getLocation().getLineNr(),
          "this is no JSON (" + e.getOriginalMessage() + ")");
    }
  }

  private static HostStart host(JsonNode one, String source, List<String> usual) {
    String name = one.path("name").asText();
    try {
      Deployment.requireContainerName(name);
      one.fieldNames()
          .forEachRemaining(
              field -> {
                if (!KNOWN.contains(field)) {
                  throw new IllegalArgumentException(
                      "the host %s has no \"%s\"; there are %s"
                          .formatted(name, field, String.join(", ", KNOWN)));
                }
              });
      List<String> topics = texts(one, "topics", name);
      topics.forEach(Deployment::requireContainerName);
      List<String> provides = texts(one, "provides", name);
      Provision.of(provides);
      List<String> command = texts(one, "command", name);
      HostStart host =
          new HostStart(
              name, Set.copyOf(topics), Set.copyOf(provides), command.isEmpty() ? usual : command);
      host.places().stream()
          .filter(place -> !HostStart.PLACES.contains(place))
          .findFirst()
          .ifPresent(
              place -> {
                throw new IllegalArgumentException(
                    "nothing is known for {%s} in the command of %s; there are {%s}"
                        .formatted(place, name, String.join("}, {", HostStart.PLACES)));
              });
      return host;
    } catch (RuntimeException e) {
      throw fault(
          source, Objects.requireNonNullElse(e.getMessage(), e.toString()).replaceAll("\\.$", ""));
    }
  }

  private static List<String> texts(JsonNode one, String field, String name) {
    JsonNode found = one.path(field);
    List<String> texts = new ArrayList<>();
    if (found.isMissingNode()) {
      return texts;
    }
    for (JsonNode text : found) {
      texts.add(text.asText());
    }
    if (!found.isArray() || texts.stream().anyMatch(String::isBlank)) {
      throw new IllegalArgumentException(
          "\"%s\" of the host %s is a list of words, such as [\"one\", \"two\"]"
              .formatted(field, name));
    }
    return texts;
  }

  private static IllegalArgumentException fault(String source, String what) {
    return new IllegalArgumentException(source + ": " + what + ".");
  }
}
