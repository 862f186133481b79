package org.maestro.agents.runtime;

import jade.core.AID;
import java.net.URI;
import java.net.URISyntaxException;
import java.util.regex.Pattern;

/**
 * Another FIPA platform, to whose agents those of ours write by HTTP.
 *
 * @param name of the platform, which is the last part of its agents' names
 * @param url where it takes messages
 */
public record OtherPlatform(String name, URI url) {
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9_.:-]*");
  private static final String USUAL_PATH = "/acc";

  /**
   * Reads {@code NAME@http://HOST:PORT}, where the path is {@code /acc} unless it is said.
   *
   * @throws IllegalArgumentException with one sentence when it cannot be read
   */
  public static OtherPlatform parse(String text) {
    int at = text.indexOf('@');
    try {
      URI url = new URI(text.substring(at + 1));
      boolean isAddress =
          "http".equals(url.getScheme()) && url.getHost() != null && url.getPort() > 0;
      if (at > 0 && NAME.matcher(text.substring(0, at)).matches() && isAddress) {
        return new OtherPlatform(
            text.substring(0, at), url.getPath().isEmpty() ? url.resolve(USUAL_PATH) : url);
      }
    } catch (URISyntaxException e) {
      throw new IllegalArgumentException(notOne(text), e);
    }
    throw new IllegalArgumentException(notOne(text));
  }

  private static String notOne(String text) {
    return "\"%s\" is no platform; write NAME@http://HOST:PORT, as ./maestro run --mtp tells it."
        .formatted(text);
  }

  /** How an agent there is addressed. */
  public AID agent(String localName) {
    AID agent = new AID(localName + "@" + name, AID.ISGUID);
    agent.addAddresses(url.toString());
    return agent;
  }

  @Override
  public String toString() {
    return name + "@" + url;
  }
}
