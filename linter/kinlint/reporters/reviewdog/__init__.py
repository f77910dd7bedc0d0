"""Reports for reviewdog, which turns them into comments and suggestions on pull requests."""
