package org.maestro.rats.link;

/** The security of a site: whether its broker makes sure of who says what. */
public enum SiteKind {
  /** The paper's bare topics are legal, on which anybody may answer for anybody. */
  OPEN,
  /** Only topics that name their sender count. */
  SECURED
}
