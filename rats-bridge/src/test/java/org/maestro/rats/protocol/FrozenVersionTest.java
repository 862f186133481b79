package org.maestro.rats.protocol;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Version 1 of the bus is frozen: what devices were built for stays as it was. */
class FrozenVersionTest {

  private static final String FROZEN = "/org/maestro/rats/frozen/";
  private static final String WHAT_TO_DO =
      "%s differs from version "
          + WireFormat.VERSION
          + " of the bus, which is frozen. docs/decisions/0014-version-1-of-the-bus.md says what"
          + " may be added, and how: with a new minor version and a frozen copy of its own beside"
          + " src/test/resources"
          + FROZEN
          + WireFormat.VERSION;

  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final WireFormat wire = new WireFormat();
  private final Schemas schemas = new Schemas();

  @Test
  void schemasAndTopicsAreTheFrozenOnes() throws IOException, URISyntaxException {
    Path shipped = directory(Schemas.class.getResource("/org/maestro/rats/protocol/call.json"));
    Path frozen = directory(getClass().getResource(FROZEN + WireFormat.VERSION + "/call.json"));
    assertThat(documents(shipped))
        .as(WHAT_TO_DO, "The list of schemas")
        .isEqualTo(documents(frozen));
    for (String document : documents(frozen)) {
      assertThat(MAPPER.readTree(shipped.resolve(document).toFile()).toPrettyString())
          .as(WHAT_TO_DO, document)
          .isEqualTo(MAPPER.readTree(frozen.resolve(document).toFile()).toPrettyString());
    }
  }

  @Test
  void messagesAreWrittenAsTheyWere() throws IOException, URISyntaxException {
    Path frozen = directory(getClass().getResource(FROZEN + WireFormat.VERSION + "/call.json"));
    List<String> written = new ArrayList<>();
    samples().forEach((kind, bytes) -> written.add(kind + " " + new String(bytes, UTF_8)));
    assertThat(written)
        .as(WHAT_TO_DO, "What is written")
        .isEqualTo(Files.readAllLines(frozen.resolve("messages.txt")));
  }

  @Test
  void messagesOfEveryFrozenVersionAreRead() throws IOException, URISyntaxException {
    Path frozen = directory(getClass().getResource(FROZEN + WireFormat.VERSION + "/call.json"));
    Map<String, Consumer<byte[]>> readers =
        Map.of(
            "call", wire::decodeCall,
            "result", wire::decodeResult,
            "progress", wire::decodeProgress,
            "observation", wire::decodeObservation,
            "status", wire::decodeStatus,
            "state", wire::decodeState,
            "verdict", wire::decodeVerdict,
            "stream", wire::decodeFrame);
    try (Stream<Path> versions = Files.list(frozen.getParent())) {
      for (Path version : versions.sorted().toList()) {
        for (String line : Files.readAllLines(version.resolve("messages.txt"))) {
          String kind = line.substring(0, line.indexOf(' '));
          byte[] message = line.substring(kind.length() + 1).getBytes(UTF_8);
          assertThatCode(() -> readers.get(kind).accept(message))
              .as(WHAT_TO_DO, "What is read")
              .doesNotThrowAnyException();
          schemas.assertValid(kind, message);
        }
      }
    }
  }

  @Test
  void reservedFeaturesAreThoseOfTheSchema() throws IOException {
    JsonNode reserved = Schemas.document("reserved.json").get("$defs");
    for (ReservedFeature feature : ReservedFeature.values()) {
      assertThat(reserved.has(feature.word() + "-parameters")).as(feature.word()).isTrue();
    }
    CostExchange exchange = new CostExchange("move", List.of(Map.of("to", "a"), Map.of()));
    JsonNode asked = MAPPER.valueToTree(exchange.parameters());
    assertThat(schemas.faults("reserved.json#/$defs/$cost-parameters", asked)).isEmpty();
    CostAnswer price = new CostAnswer(Optional.of(2.5), Optional.of(2.0), Optional.empty());
    CostAnswer none = new CostAnswer(Optional.empty(), Optional.empty(), Optional.of("no way"));
    JsonNode answered = MAPPER.valueToTree(CostExchange.values(List.of(price, none)));
    assertThat(schemas.faults("reserved.json#/$defs/$cost-values", answered)).isEmpty();
    assertThat(schemas.faults("reserved.json#/$defs/$cost-values", asked)).isNotEmpty();
  }

  private Map<String, byte[]> samples() {
    Map<String, Object> parameters = new LinkedHashMap<>();
    parameters.put(
        "object", Map.of("ref", "urn:home:arena#GreenObject", "position", List.of(2.1, 0.4, 0.1)));
    parameters.put("level", 0.5);
    parameters.put("gentle", true);
    Call call =
        new Call(
            "cca-7-1",
            Optional.of("rose"),
            Optional.of("7f3"),
            "pick",
            parameters,
            Duration.ofSeconds(15),
            "cca",
            Optional.of("G12"),
            Optional.of(new Call.Expectation(4.5, 4)),
            Optional.of(new Call.Sent("k3", 120_500)));
    RatsError error =
        new RatsError(
            ErrorCode.PRECONDITION_NOT_MET,
            RatsError.Level.WARNING,
            "16 lux in zone-b, 72 needed",
            Optional.of("raise the light in zone-b"),
            List.of(new RatsError.Reference("(illuminance zone-b)", ">= 72", 16)),
            true);
    Map<String, byte[]> samples = new LinkedHashMap<>();
    samples.put("call", wire.encode(call));
    samples.put(
        "result",
        wire.encode(
            new Result("c1", "cam-b", Outcome.FAILED, "standby", Map.of(), Optional.of(error))));
    samples.put(
        "progress",
        wire.encode(
            new Progress("c1", "rose", Progress.Kind.ESTABLISHED, 0.25, Map.of("found", true))));
    samples.put(
        "observation", wire.encode(new Observation("c1", "lux-a", "measure", Map.of("lux", 16.5))));
    samples.put("status", wire.encode(new MemberStatus("rose", MemberStatus.Phase.READY, "7f3")));
    samples.put(
        "state",
        wire.encode(
            new MemberState(
                "rose",
                "7f3",
                "busy",
                List.of("(in Cup rose)"),
                List.of("c1"),
                List.of("c2"),
                List.of("pick"))));
    samples.put(
        "verdict",
        wire.encode(
            new Verdict(
                "rose",
                "7f3",
                false,
                List.of(
                    new Verdict.Fault(
                        12,
                        "ring",
                        "maestro:effect",
                        "uses the unknown predicate calld",
                        "write called, if that is meant")))));
    samples.put(
        "stream",
        wire.encode(
            new StreamFrame(
                "c1",
                "cam-a",
                "streamPictures",
                17,
                Instant.parse("2026-03-01T18:00:00.250Z"),
                "image/png",
                new byte[] {(byte) 0x89, 'P', 'N', 'G'})));
    return samples;
  }

  private static Path directory(URL document) throws URISyntaxException {
    return Path.of(Objects.requireNonNull(document).toURI()).getParent();
  }

  private static TreeSet<String> documents(Path directory) throws IOException {
    try (Stream<Path> files = Files.list(directory)) {
      TreeSet<String> names = new TreeSet<>();
      files
          .map(file -> file.getFileName().toString())
          .filter(n -> n.endsWith(".json"))
          .forEach(names::add);
      return names;
    }
  }
}
