package org.maestro.rats.protocol;

/** What is enough to refuse a malformed call: its id, and the member that it is for. */
public record CallAddress(String id, String member) {}
