package org.maestro.launch;

import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.maestro.language.Language;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.RoomHearing;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Lists the agents of rooms that listen, and how many words each knows (ADE, 2; A13). */
@Command(
    name = "rooms",
    description = "List the agents that listen in a home's rooms, and how many words each knows.")
final class RoomsCommand implements Callable<Integer> {
  private static final List<String> COLUMNS =
      List.of("agent", "hears in", "understands", "constructions", "words", "speaks as");

  @Spec private CommandSpec spec;

  @Parameters(
      paramLabel = "HOME.ttl",
      completionCandidates = Shipped.Homes.class,
      description = "A home file, or a shipped home: rooms, evening.")
  private String home = "";

  @Override
  public Integer call() {
    PrintWriter out = spec.commandLine().getOut();
    Home read = Shipped.home(home);
    Language language = SpokenLanguage.of(read, Optional.empty(), Optional.empty());
    List<List<String>> rows =
        read.groups().values().stream()
            .filter(group -> group.hearing().isPresent())
            .map(group -> row(read, language, group, group.hearing().orElseThrow()))
            .toList();
    if (rows.isEmpty()) {
      out.println(
          "No agent listens in a room of this home; what is said is understood with all its words."
              + " docs/guide-words.md tells how rooms are made to listen.");
    } else {
      new Table(COLUMNS, rows).print(out);
    }
    return ExitCode.DONE;
  }

  private static List<String> row(Home home, Language language, Group group, RoomHearing hearing) {
    return List.of(
        group.id(),
        String.join(" ", hearing.rooms()),
        String.join(" ", hearing.topics()),
        String.valueOf(home.wording().about(hearing.topics()).constructions().size()),
        String.valueOf(language.about(hearing.topics()).lexicon().words().size()),
        hearing.persona().orElse(""));
  }
}
