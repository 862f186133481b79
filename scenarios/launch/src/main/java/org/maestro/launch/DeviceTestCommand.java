package org.maestro.launch;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.type.TypeReference;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.io.PrintWriter;
import java.net.URI;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import org.maestro.assembly.SiteBus;
import org.maestro.console.documents.JsonMembers;
import org.maestro.rats.conformance.DeviceExamination;
import org.maestro.rats.conformance.DeviceRule;
import org.maestro.rats.conformance.FeatureCall;
import org.maestro.rats.conformance.Finding;
import org.maestro.rats.conformance.Patience;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.text.VisibleText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Plays the platform against one device, and tells which rules of the bus it keeps. */
@Command(
    name = "test",
    description =
        "Call a device as a platform does, and as nobody should, and tell for each rule of the bus"
            + " that can be seen from outside whether it keeps it. No platform is needed; it takes"
            + " about half a minute. Features are called only when named with --call.",
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:no rule is broken",
      "1:a rule is broken",
      "2:bad input",
      "3:no broker answers there"
    })
final class DeviceTestCommand implements Callable<Integer> {
  private static final String EXAMINER = "examiner";
  private static final List<String> COLUMNS = List.of("rule", "verdict", "says", "seen");

  @Spec private CommandSpec spec;
  @Mixin private SecurityOptions security;

  @Parameters(index = "0", paramLabel = "URI", description = "The MQTT 5 broker, tcp://HOST:PORT.")
  private String broker;

  @Parameters(index = "1", paramLabel = "ID", description = "The device's id.")
  private String member;

  @Option(
      names = "--site",
      paramLabel = "NAME",
      defaultValue = "maestro",
      description = "The site's name; default ${DEFAULT-VALUE}.")
  private String site = "maestro";

  @Option(
      names = "--call",
      paramLabel = "FEATURE={...}",
      description =
          "A feature that may be called a dozen times, and ended meanwhile, with its parameters as"
              + " JSON, such as brew={\"drink\":{\"ref\":\"x#tea\"}}; best one that takes a second.")
  private Optional<String> call = Optional.empty();

  @Option(
      names = "--user",
      paramLabel = "ID",
      defaultValue = "cca",
      description =
          "As which controller of a secured site to ask; default ${DEFAULT-VALUE}. No platform may"
              + " run under that name meanwhile.")
  private String user = "cca";

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    Optional<FeatureCall> named = call.map(DeviceTestCommand::parsed);
    URI uri = Endpoint.broker(broker);
    Optional<SiteSecurity> files = security.files();
    new SiteBus(uri, site, files).requireLetIn(files.isPresent() ? user : EXAMINER);
    PahoTransport transport =
        files
            .map(its -> new PahoTransport(uri, its.password(user)))
            .orElseGet(() -> new PahoTransport(uri, EXAMINER));
    List<Finding> findings =
        new DeviceExamination(transport, site, member, named, files.isEmpty(), Patience.USUAL)
            .run();
    print(findings);
    return is(findings, Finding.Verdict.BROKEN) == 0 ? ExitCode.DONE : ExitCode.NOT_REACHED;
  }

  private static FeatureCall parsed(String text) {
    String[] parts = text.split("=", 2);
    try {
      return new FeatureCall(
          parts[0],
          parts.length == 1
              ? Map.of()
              : new ObjectMapper()
                  .readValue(parts[1], new TypeReference<Map<String, Object>>() {}));
    } catch (JsonProcessingException e) {
      throw CommandException.badInput(
          "--call takes a feature and its parameters as a JSON object, such as"
              + " brew={\"cups\":1}, and not "
              + text
              + ".");
    }
  }

  private static long is(List<Finding> findings, Finding.Verdict verdict) {
    return findings.stream().filter(finding -> finding.verdict() == verdict).count();
  }

  private void print(List<Finding> findings) {
    PrintWriter out = spec.commandLine().getOut();
    if (json) {
      out.println(document(member, findings));
      return;
    }
    new Table(
            COLUMNS,
            findings.stream()
                .map(
                    finding ->
                        List.of(
                            String.valueOf(finding.rule().number()),
                            word(finding.verdict()),
                            finding.rule().sentence(),
                            VisibleText.line(finding.why())))
                .toList())
        .print(out);
    out.printf(
        "%d kept, %d broken, %d not tried. These are %d of the %d rules of docs/bus-rules.md; whether a"
            + " device keeps the others cannot be seen from outside, or they are not a device's.%n",
        is(findings, Finding.Verdict.KEPT),
        is(findings, Finding.Verdict.BROKEN),
        is(findings, Finding.Verdict.NOT_TRIED),
        findings.size(),
        DeviceRule.OF_ALL);
    out.flush();
  }

  private static String word(Finding.Verdict verdict) {
    return verdict.name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  static String document(String member, List<Finding> findings) {
    JsonMembers document =
        JsonMembers.empty()
            .text("member", member)
            .number("rules", OptionalInt.of(DeviceRule.OF_ALL));
    ArrayNode array = document.node().putArray("findings");
    for (Finding finding : findings) {
      JsonMembers.in(array)
          .number("rule", OptionalInt.of(finding.rule().number()))
          .text("says", finding.rule().sentence())
          .text("verdict", word(finding.verdict()))
          .text("seen", finding.why());
    }
    return document.toString();
  }
}
