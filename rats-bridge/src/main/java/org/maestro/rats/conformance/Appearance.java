package org.maestro.rats.conformance;

import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a device tells on its topics of who it is, and that it is there.
 *
 * @param told the last part of each topic on which it tells, with what it told there first
 */
record Appearance(Map<String, Examiner.Heard> told) {

  private static final List<String> PARTS = List.of("status", "description", "state");

  static Appearance of(Bench bench) {
    Map<String, Examiner.Heard> told = new LinkedHashMap<>();
    for (String part : PARTS) {
      bench.examiner().retained(topic(bench, part)).ifPresent(heard -> told.put(part, heard));
    }
    return new Appearance(told);
  }

  private static String topic(Bench bench, String part) {
    return switch (part) {
      case "status" -> bench.topics().status(bench.member());
      case "state" -> bench.topics().state(bench.member());
      default -> bench.topics().description(bench.member());
    };
  }

  boolean isThere() {
    return told.containsKey("status");
  }

  /** Empty when its status names none. */
  String boot() {
    return Optional.ofNullable(told.get("status"))
        .map(status -> status.content().path("boot").asText())
        .orElse("");
  }

  Finding topics(Bench bench) {
    List<String> missing = PARTS.stream().filter(part -> !told.containsKey(part)).toList();
    return missing.isEmpty()
        ? kept(DeviceRule.TOPICS, "status, description and state are told")
        : broken(
            DeviceRule.TOPICS,
            "nothing was heard on %s of member/%s within %d s"
                .formatted(
                    String.join(", ", missing),
                    bench.member(),
                    bench.patience().appearsWithin().toSeconds()));
  }

  List<String> notRetained() {
    return told.entrySet().stream()
        .filter(entry -> !entry.getValue().retained())
        .map(Map.Entry::getKey)
        .toList();
  }

  /** Whether all that it told is told again since then. */
  Optional<String> missingSince(int since, Bench bench) {
    return told.keySet().stream()
        .filter(
            part ->
                bench
                    .examiner()
                    .await(
                        since,
                        heard -> heard.topic().equals(topic(bench, part)),
                        bench.patience().answersWithin())
                    .isEmpty())
        .findFirst();
  }

  Optional<JsonNode> description() {
    return Optional.ofNullable(told.get("description")).map(Examiner.Heard::content);
  }

  /** A feature that it describes; empty when none can be read. */
  Optional<String> offered() {
    return description()
        .map(description -> description.path("offers"))
        .map(offers -> offers.isArray() ? offers.path(0) : offers)
        .map(Appearance::nameOf)
        .filter(name -> !name.isEmpty());
  }

  private static String nameOf(JsonNode offer) {
    String iri =
        offer.isTextual()
            ? offer.textValue()
            : offer.path("id").asText(offer.path("@id").asText(offer.path("type").asText()));
    return iri.replaceFirst(".*[#/:]", "");
  }
}
