package org.maestro.assembly;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.stream.Recording;
import org.maestro.rats.stream.Replay;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Transport;

/**
 * Members at the ends of streams that no home describes (ADE, 3.3; A44): they bring their own
 * words, from the descriptions beside this class.
 */
public final class StreamMember {
  /** The feature by which a recording is streamed. */
  public static final String REPLAY = "replay";

  private static final String REST = "standby";

  private StreamMember() {}

  /**
   * A recording joins as a member that streams it to whoever asks.
   *
   * @param id the member's
   * @param policy of the site
   * @param transport not open yet; closed with the member
   */
  public static RatsMember replaying(
      Recording recording,
      String id,
      CallPolicy policy,
      Transport transport,
      String site,
      Clock clock) {
    MemberProfile.Feature feature =
        new MemberProfile.Feature(
            REPLAY,
            Set.of(),
            Set.of(),
            true,
            Optional.empty(),
            REST,
            new Replay(recording, id, clock));
    MemberProfile profile = profile(id, description("replay", id), Map.of(REPLAY, feature));
    return RatsMember.start(profile, List::of, transport, site, policy, clock);
  }

  static MemberProfile profile(
      String id, String description, Map<String, MemberProfile.Feature> features) {
    return new MemberProfile(id, description, Set.of(REST), REST, Set.of(REST), features);
  }

  static String description(String name, String id) {
    try (InputStream text =
        Objects.requireNonNull(StreamMember.class.getResourceAsStream(name + ".json"))) {
      return new String(text.readAllBytes(), UTF_8).replace("{id}", id);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The facts of a description's reports, by the word that is told. */
  static Map<String, String> reports(String description) {
    try {
      Map<String, String> facts = new TreeMap<>();
      for (JsonNode report : new ObjectMapper().readTree(description).get("reports")) {
        facts.put(report.get("name").textValue(), report.get("fact").textValue());
      }
      return facts;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
