package org.maestro.knowledge.api;

import java.net.URI;
import java.nio.file.Path;

/** The place where the RDF dataset of the collective knowledge is kept. */
public sealed interface Store {

  /** In this process, and gone with it. */
  record InMemory() implements Store {}

  /** In files (TDB2) that outlive the process, also one that is killed. */
  record OnDisk(Path directory) implements Store {}

  /**
   * Behind a SPARQL 1.1 endpoint, which others may read too.
   *
   * @param queries where it takes queries
   * @param updates where it takes updates; many take both at one address
   */
  record Endpoint(URI queries, URI updates) implements Store {}

  Store IN_MEMORY = new InMemory();

  /**
   * As people write it: a directory; or an address, or two with a comma between, the first for
   * queries, the second for updates.
   *
   * @throws KnowledgeException when it is an address that cannot be one
   */
  static Store parse(String text) {
    if (!text.startsWith("http://") && !text.startsWith("https://")) {
      return new OnDisk(Path.of(text));
    }
    String[] addresses = text.split(",", 2);
    return new Endpoint(address(addresses[0]), address(addresses[addresses.length - 1]));
  }

  private static URI address(String text) {
    try {
      URI address = URI.create(text.strip());
      if (address.getHost() != null) {
        return address;
      }
    } catch (IllegalArgumentException e) {
      throw new KnowledgeException(noAddress(text), e);
    }
    throw new KnowledgeException(noAddress(text));
  }

  private static String noAddress(String text) {
    return "\""
        + text
        + "\" is no address of a SPARQL endpoint; write one such as http://localhost:3030/home, or"
        + " a directory.";
  }
}
