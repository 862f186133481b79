package org.maestro.sl;

import java.util.List;

/**
 * A script in the notation in which ADE's action scripts are printed (ADE, 5; A76), line by line:
 *
 * <pre>
 * script: prepareRoom
 * agent: livingroom
 * name: show
 * activateLights(livingroom)
 * show := queryPrefs(livingroom, "TV show", currenttime)
 * </pre>
 *
 * <p>A call runs the script of its name. An {@code agent:} is given when the script is run, a
 * {@code name:} by a step of it.
 *
 * @param agents in the order in which they are given
 * @param body the same steps in MAESTRO-SL; agents and names are its variables
 */
public record PrintedScript(String name, List<String> agents, Body body) {
  public PrintedScript {
    agents = List.copyOf(agents);
  }
}
