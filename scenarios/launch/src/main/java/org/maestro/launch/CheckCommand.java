package org.maestro.launch;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeFaultException;
import org.maestro.ontology.home.ImpossibleUses;
import org.maestro.ontology.home.UnstatedNeeds;
import org.maestro.ontology.validation.Fault;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Reads a home file and tells its faults. */
@Command(name = "check", description = "Tell every fault of a home file, with its line and cure.")
final class CheckCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Parameters(paramLabel = "HOME.ttl", description = "A home file, or a shipped home: bob, arena.")
  private String home;

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    PrintWriter out = spec.commandLine().getOut();
    try {
      Home loaded = Shipped.home(home);
      List<String> notes = new ArrayList<>(UnstatedNeeds.of(loaded));
      notes.addAll(ImpossibleUses.of(loaded));
      if (json) {
        out.println(document(List.of(), notes));
      } else {
        notes.forEach(note -> out.println("Note: " + note));
        out.printf(
            "%s: no fault; %d devices, %d things in all.%n",
            home, loaded.devices().size(), loaded.individuals().size());
      }
      return ExitCode.DONE;
    } catch (HomeFaultException e) {
      if (json) {
        out.println(document(e.faults(), List.of()));
      } else {
        e.faults().forEach(fault -> out.println(fault.toString()));
        out.println(e.faults().size() == 1 ? "1 fault." : e.faults().size() + " faults.");
      }
      return ExitCode.NOT_REACHED;
    }
  }

  private String document(List<Fault> faults, List<String> notes) {
    ObjectNode document = new ObjectMapper().createObjectNode();
    document.put("home", home);
    ArrayNode array = document.putArray("faults");
    for (Fault fault : faults) {
      ObjectNode node = array.addObject();
      node.put("source", fault.source());
      node.put("line", fault.line());
      node.put("subject", fault.subject());
      node.put("property", fault.property());
      node.put("problem", fault.problem());
      node.put("cure", fault.cure());
    }
    notes.forEach(document.putArray("notes")::add);
    return document.toString();
  }
}
