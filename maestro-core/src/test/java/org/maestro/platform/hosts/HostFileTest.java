package org.maestro.platform.hosts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.deployment.Provision;

/** Which hosts belong to a platform, and how their processes are started (ADE, 3.2; A35, A36). */
class HostFileTest {
  private static final List<String> USUAL = List.of("java", "--main={main}", "--topic={topics}");

  @Test
  void aTemplateIsFilledInAndNoShellReadsIt() {
    HostStart attic =
        HostFile.read(
                """
                {"hosts": [{"name": "attic", "topics": ["robots", "lights"],
                  "provides": ["radio", "memory 512"],
                  "command": ["ssh", "pi@attic", "maestro", "container", "--main", "{main}",
                              "--name={name}", "--topic={topics}", "--provides={provides}"]}]}
                """,
                "hosts.json",
                USUAL)
            .get(0);

    assertThat(attic.command("10.0.0.1:1099"))
        .containsExactly(
            "ssh",
            "pi@attic",
            "maestro",
            "container",
            "--main",
            "10.0.0.1:1099",
            "--name=attic",
            "--topic=lights,robots",
            "--provides=memory=512,radio");
    assertThat(Provision.of(List.of("memory=512")).lacks(Provision.of(List.of("memory 500"))))
        .isEmpty();
  }

  @Test
  void aHostWithoutACommandIsAProcessOfThisMachineAndWhatIsEmptyIsLeftAway() {
    HostStart plain =
        HostFile.read("{\"hosts\": [{\"name\": \"shed\"}]}", "hosts.json", USUAL).get(0);

    assertThat(plain.command("127.0.0.1:7")).containsExactly("java", "--main=127.0.0.1:7");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          {"hosts": [| hosts.json, line 1: this is no JSON
          {"hosts": []}| hosts.json: it names no hosts
          {"hosts": [{"name": "At tic"}]}| "At tic" is no name for a container
          {"hosts": [{"name": "a", "topic": "x"}]}| the host a has no "topic"; there are command, name
          {"hosts": [{"name": "a", "command": "ssh"}]}| "command" of the host a is a list of words
          {"hosts": [{"name": "a", "command": ["{port}"]}]}| nothing is known for {port} in the command of a
          {"hosts": [{"name": "a", "provides": ["a b"]}]}| "a b" is nothing that a host provides
          {"hosts": [{"name": "a"}, {"name": "a"}]}| there are two hosts named a
          """)
  void aFaultIsOneSentence(String text, String sentence) {
    assertThatThrownBy(() -> HostFile.read(text, "hosts.json", USUAL))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("hosts.json")
        .hasMessageContaining(sentence);
  }
}
