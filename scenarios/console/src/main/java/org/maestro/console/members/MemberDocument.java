package org.maestro.console.members;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.console.documents.JsonMembers;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;

/** The document of one member: what it is at, what waits, and what it can do now. */
final class MemberDocument {
  private static final double NANOS_PER_MILLI = 1e6;

  private MemberDocument() {}

  /**
   * @param device as it is described
   * @param heard from it on the bus
   * @param roundTrip how soon it answers, in wall time
   */
  static JsonNode of(
      String name,
      Optional<Device> device,
      Optional<RatsLink.Member> heard,
      Optional<Duration> roundTrip) {
    Optional<MemberState> state = heard.flatMap(RatsLink.Member::state);
    JsonMembers document =
        JsonMembers.empty()
            .text("member", name)
            .text("phase", heard.map(MemberDocument::phase))
            .text("state", state.map(MemberState::state))
            .words("running", state.map(MemberState::running).orElse(List.of()))
            .words("queue", state.map(MemberState::queue).orElse(List.of()))
            .number(
                "round_trip_ms",
                roundTrip.isPresent()
                    ? OptionalDouble.of(roundTrip.get().toNanos() / NANOS_PER_MILLI)
                    : OptionalDouble.empty());
    ArrayNode features = document.node().putArray("features");
    device.map(Device::features).orElse(List.of()).stream()
        .sorted(Comparator.comparing(FeatureType::name, String.CASE_INSENSITIVE_ORDER))
        .forEach(feature -> feature(JsonMembers.in(features), name, feature, heard));
    return document.node();
  }

  private static String phase(RatsLink.Member member) {
    return member.phase().name().toLowerCase(Locale.ROOT);
  }

  private static void feature(
      JsonMembers row, String member, FeatureType feature, Optional<RatsLink.Member> heard) {
    row.text("feature", feature.name())
        .text("sentence", feature.sentence())
        .truth("continuous", feature.continuous())
        .text("why_not", whyNot(member, feature, heard));
    ArrayNode parameters = row.node().putArray("parameters");
    feature.inputs().stream()
        .filter(parameter -> !parameter.types().contains(Parameter.NEXT_PLACE))
        .forEach(
            parameter ->
                JsonMembers.in(parameters)
                    .text("name", parameter.name())
                    .words("types", parameter.types())
                    .terms("one_of", parameter.oneOf())
                    .truth("optional", parameter.optional()));
  }

  /** Why the feature cannot be called now; empty when nothing is known that forbids it. */
  private static Optional<String> whyNot(
      String member, FeatureType feature, Optional<RatsLink.Member> heard) {
    if (heard.isEmpty()) {
      return Optional.of(member + " was not heard of on the bus yet.");
    }
    if (heard.get().phase() != MemberStatus.Phase.READY) {
      return Optional.of("%s is %s.".formatted(member, phase(heard.get())));
    }
    return heard
        .get()
        .state()
        .filter(state -> state.disabled().contains(feature.name()))
        .map(
            state ->
                "%s says that it cannot do this now; its state is %s."
                    .formatted(member, state.state()));
  }
}
