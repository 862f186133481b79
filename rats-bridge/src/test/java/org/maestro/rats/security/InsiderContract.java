package org.maestro.rats.security;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.rats.security.SecuredSite.await;
import static org.maestro.rats.security.SecuredSite.isReady;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.rats.broker.TestBroker;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.member.TestDevice;

/**
 * A lamp turned bad: it has valid credentials and a client of another language, and can neither
 * open the door, nor read what the camera sees, nor speak as anybody else.
 */
abstract class InsiderContract {

  private static final int REFUSED = 0x80;

  @TempDir Path directory;

  abstract TestBroker broker(Path files);

  @Test
  void canNeitherSpeakAsAnotherNorReadForOthers() throws Exception {
    Path files = SecuredSite.files(directory);
    try (SecuredSite site = new SecuredSite(files, broker(files))) {
      TestDevice door = site.join(site.security.password("door"));
      site.join(site.security.password("cam-1.a"));
      RatsLink link = site.connect(site.security.password("cca"));
      await(() -> isReady(link, "cam-1.a") && isReady(link, "door"));
      String doorsLife = boot(link, "door");
      List<String> changes = new CopyOnWriteArrayList<>();
      link.watch(member -> changes.add(member.id() + " " + member.phase()));
      Process insider = start(site);
      try (BufferedReader output = insider.inputReader(UTF_8);
          Writer input = new OutputStreamWriter(insider.getOutputStream(), UTF_8)) {
        Map<String, List<JsonNode>> told = tried(output);
        SecuredBusContract.Heard watch = new SecuredBusContract.Heard();
        link.call(
            "cam-1.a",
            "watch",
            Map.of("object", "safe"),
            Duration.ofSeconds(30),
            Optional.empty(),
            watch);
        await(() -> !watch.observations.isEmpty());
        SecuredBusContract.Heard last = new SecuredBusContract.Heard();
        link.call("door", "end", Map.of(), Duration.ofSeconds(30), Optional.empty(), last);
        await(() -> !last.results.isEmpty());
        input.write("\n");
        input.flush();
        Map<String, List<JsonNode>> end = tried(output);
        assertThat(insider.waitFor(30, TimeUnit.SECONDS)).isTrue();
        assertThat(door.log).as("what the door was made to do").isEmpty();
        assertThat(changes).contains("door READY").doesNotContain("door LOST");
        assertThat(boot(link, "door")).isEqualTo(doorsLife);
        assertThat(isReady(link, "door")).as("its state is still there").isTrue();
        assertRefused(told);
        assertThat(end.get("heard").stream().map(JsonNode::asText).toList())
            .as("what it heard of others")
            .noneMatch(topic -> topic.contains("/result/"))
            .noneMatch(topic -> topic.contains("/progress/"))
            .noneMatch(topic -> topic.endsWith("/state"))
            .noneMatch(topic -> topic.contains("/observation/"));
      } finally {
        insider.destroyForcibly();
      }
    }
  }

  private static void assertRefused(Map<String, List<JsonNode>> told) {
    for (String own : List.of("publish call/lamp", "publish member/lamp/state")) {
      assertThat(told.get(own)).as(own).allMatch(code -> code.asInt(REFUSED) < REFUSED);
    }
    told.forEach(
        (attempt, codes) -> {
          boolean foreign =
              attempt.startsWith("publish ") && !attempt.contains("/lamp")
                  || attempt.startsWith("connect with")
                      && !attempt.contains("client id")
                      && !attempt.contains("will");
          if (foreign) {
            assertThat(codes)
                .as(attempt)
                .isNotEmpty()
                .allMatch(code -> code.isTextual() || code.isNull() || code.asInt() >= REFUSED);
          }
        });
  }

  private Process start(SecuredSite site) throws IOException {
    return new ProcessBuilder(
            "python3",
            Path.of("src/test/resources/insider.py").toAbsolutePath().toString(),
            String.valueOf(site.uri().getPort()),
            directory.resolve("users/lamp/ca.pem").toString(),
            PrivateFiles.secret(directory.resolve("users/lamp/password")).strip())
        .redirectError(ProcessBuilder.Redirect.INHERIT)
        .start();
  }

  /** Up to the point where it waits or ends. */
  private static Map<String, List<JsonNode>> tried(BufferedReader output) throws IOException {
    Map<String, List<JsonNode>> told = new LinkedHashMap<>();
    ObjectMapper json = new ObjectMapper();
    for (String line = output.readLine(); line != null; line = output.readLine()) {
      JsonNode node = json.readTree(line);
      List<JsonNode> codes =
          told.computeIfAbsent(node.get("attempt").asText(), key -> new ArrayList<>());
      node.get("codes").forEach(codes::add);
      if (node.get("attempt").asText().equals("listening")) {
        break;
      }
    }
    return told;
  }

  private static String boot(RatsLink link, String id) {
    return link.members().stream()
        .filter(member -> member.id().equals(id))
        .map(RatsLink.Member::boot)
        .findFirst()
        .orElseThrow();
  }
}
